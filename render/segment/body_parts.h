#pragma once
/// Parts of a patient that a picture can show alone or leave out, as masks with smooth edges. Rules of density and
/// geometry, no learning, no atlas: crude, and each says what it misses.
///   peeled   all that lies deeper below the body's surface than so many mm
///   lungs    air inside the body, at least 150 ml and not pure gas as in bowel, with the vessels in it (closed by
///            8 mm), without the outermost 5 mm, where fat and pleura shine through
///   bones    what hangs together with dense bone and is no blood with contrast medium (bone_cells.h): marrow and blood
///            may have the same HU, so that no curve parts them
/// Errors are those of bodyMask() and, of kind refused, why a part cannot be told. Else cancelled().

#include <memory>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/mask.h"
#include "render/volume/volume.h"

namespace pdr::segment {

using PartMask = Result<std::shared_ptr<const Mask>>;

/// `depthMm`: [0, 50].
PartMask peeled(const Volume& volume, double depthMm, const Progress& progress);

PartMask lungs(const Volume& volume, const Progress& progress);

/// The bones, or all but them.
enum class Bones { shown, hidden };
PartMask bones(const Volume& volume, Bones wanted, const Progress& progress);

}  // namespace pdr::segment
