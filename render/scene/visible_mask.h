#pragma once
/// From the choice of what is shown to the mask that shows it.

#include <memory>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/visible.h"
#include "render/segment/body_parts.h"

namespace pdr {

/// The mask of what `visible` shows of a scan whose parts are `parts`, for voxels that lie as `on` says; null:
/// everything. Errors of kind refused say why a part cannot be told from the rest of this scan. Else cancelled(), or
/// that memory does not suffice.
segment::PartMask visibleMask(const segment::BodyParts& parts, const Visible& visible, const VolumeGeometry& on,
                              const Progress& progress);

}  // namespace pdr
