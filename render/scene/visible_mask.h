#pragma once
/// Makes the mask of the visible part of a scan.

#include <memory>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/visible.h"
#include "render/segment/body_parts.h"

namespace pdr {

/// Returns the mask of what `visible` shows of a scan whose parts are `parts`, on the voxel grid `on`; null:
/// everything. An error of kind refused says why a part cannot be told from the rest of this scan. Other errors:
/// cancelled(), or too little memory.
segment::PartMask visibleMask(const segment::BodyParts& parts, const Visible& visible, const VolumeGeometry& on,
                              const Progress& progress);

}  // namespace pdr
