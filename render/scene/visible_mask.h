#pragma once
/// From the choice of what is shown to the mask that shows it.

#include <memory>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/visible.h"
#include "render/volume/mask.h"

namespace pdr {

/// The mask of what `visible` shows of `volume`; null: everything. Errors of kind refused say why a part cannot be told
/// from the rest of this scan. Else cancelled(), or that memory does not suffice.
Result<std::shared_ptr<const Mask>> visibleMask(const Volume& volume, const Visible& visible, const Progress& progress);

}  // namespace pdr
