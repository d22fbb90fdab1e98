#pragma once
/// Parts of a patient that a picture can show alone or leave out, as masks with smooth edges. Rules of density and
/// geometry, no learning, no atlas: crude, and each says what it misses.
///   peeled   all that lies deeper below the body's surface than so many mm
///   lungs    air inside the body, at least 150 ml and not pure gas as in bowel, with the vessels in it (closed by
///            8 mm), without the outermost 5 mm, where fat and pleura shine through
///   bones    what hangs together with dense bone and is no blood with contrast medium (bone_cells.h): marrow and blood
///            may have the same HU, so that no curve parts them

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/body_mask.h"
#include "render/segment/smooth_distance.h"
#include "render/volume/mask.h"
#include "render/volume/volume.h"

namespace pdr::segment {

using PartMask = Result<std::shared_ptr<const Mask>>;

/// The bones, or all but them.
enum class Bones { shown, hidden };

/// What is found out at most once, unless it is refused or cancelled; threads take turns.
template <typename T>
struct Found {
    std::mutex mutex;
    std::shared_ptr<const T> value;
};

/// Of one volume. What several parts need is found out once, by whoever asks first; others wait for it. Errors are
/// those of bodyMask() and, of kind refused, why a part cannot be told. Else cancelled().
class BodyParts {
  public:
    explicit BodyParts(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}

    const Volume& volume() const { return *volume_; }

    /// `on`: whose voxels the mask is for: the volume's own, or other ones in the same patient.
    /// `depthMm`: [0, 50].
    PartMask peeled(double depthMm, const VolumeGeometry& on, const Progress& progress) const;
    PartMask lungs(const VolumeGeometry& on, const Progress& progress) const;
    PartMask bones(Bones wanted, const VolumeGeometry& on, const Progress& progress) const;

    /// Gives back most of the memory of what was found out, for when many parts have been asked for and few will be
    /// soon. They take a little longer then.
    void forgetDistances() const;

  private:
    using Distance = Result<std::shared_ptr<const SmoothDistance>>;
    using FoundCells = Result<std::shared_ptr<const Cells>>;  ///< not all of them 0

    Result<std::shared_ptr<const BodyMask>> body(const Progress& progress) const;
    /// From the skin inwards, known as far as `depthMm`.
    Distance belowSkin(double depthMm, const Progress& progress) const;
    /// From the surface of the lungs, widened by their vessels, inwards.
    Distance inLungs(const Progress& progress) const;
    /// From the bones outwards.
    Distance fromBones(const Progress& progress) const;
    /// The lungs and their vessels.
    FoundCells aroundLungs(const BodyMask& body, const Progress& progress) const;
    FoundCells cellsOfBones(const CellGrid& grid, const Progress& progress) const;
    template <typename WeightOf>
    PartMask maskOn(const VolumeGeometry& on, const Distance& distance, Text hidden, const Progress& progress,
                    const WeightOf& weightOf) const;

    std::shared_ptr<const Volume> volume_;
    mutable Found<BodyMask> body_;  ///< its body alone
    mutable Found<Cells> aroundLungs_, bones_;
    /// Four times as large as the cells that they are of. Of either pair the one that was asked for last is kept: what
    /// peels and a part may be wanted together.
    mutable Found<SmoothDistance> belowSkin_, deepBelowSkin_, inLungs_, fromBones_;
};

}  // namespace pdr::segment
