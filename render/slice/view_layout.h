#pragma once
/// The layouts of the views: the image, and the three slices beside it.

namespace pdr {

enum class ViewLayout {
    image,     ///< the image alone
    beside,    ///< the image, and the slices in a column to its right
    quarters,  ///< four views of the same size: the axial slice and the image above, the other slices below
};
inline constexpr ViewLayout kViewLayouts[] = {ViewLayout::image, ViewLayout::beside, ViewLayout::quarters};

}  // namespace pdr
