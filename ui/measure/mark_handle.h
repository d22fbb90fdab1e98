#pragma once
/// The handles of measurements in a view: the places of which the pointer can take hold.

#include <cstddef>
#include <functional>
#include <optional>

#include "ui/measure/shown_mark.h"
#include "ui/view/view_pointer.h"

namespace pdr::ui {

/// How near the pointer takes hold of a handle [px].
inline constexpr double kHandleReach = 9;

/// A place of a measurement.
struct MarkHandle {
    std::uint64_t id = 0;  ///< the id of a measurement
    int index = 0;         ///< the index of one of its places
    bool operator==(const MarkHandle&) const = default;
};

/// Returns the handle within reach that is nearest to the pointer, in a view that has an image; none: there is none.
/// `has`: whether a place of a mark has a handle.
std::optional<MarkHandle> handleAt(const std::vector<ShownMark>& marks, const ViewPointer& pointer,
                                   const std::function<bool(const ShownMark&, std::size_t)>& has);

/// Returns `mark` with the place of `handle`, if it is one of its places, at the point `at` of the view [px], as deep
/// in the view as it was. The mark then has no text: what it would measure is not known.
ShownMark movedTo(const ShownMark& mark, const MarkHandle& handle, const ImagePlace& image, QPointF at);

}  // namespace pdr::ui
