#pragma once
/// Parts of a scan in colours on its slices.

#include <QImage>
#include <memory>
#include <optional>
#include <vector>

#include "render/slice/slice_plane.h"
#include "render/volume/label_map.h"

namespace pdr::app {

struct SliceTint {
    std::shared_ptr<const LabelMap> map;              ///< null: no part has a colour
    std::vector<std::optional<LabelColour>> colours;  ///< one for each part of the map; none: it stays grey
    bool operator==(const SliceTint&) const = default;
};

/// Colours the pixels of `image`, a slice on `plane` (Format_RGB32), whose nearest voxel is in a part with a colour:
/// the scan shines through.
void tint(const SliceTint& tint, const SlicePlane& plane, QImage& image);

}  // namespace pdr::app
