#include "ui/measure/mark_handle.h"

#include <QLineF>

#include "ui/view/view_places.h"

namespace pdr::ui {

std::optional<MarkHandle> handleAt(const std::vector<ShownMark>& marks, const ViewPointer& pointer,
                                   const std::function<bool(const ShownMark&, std::size_t)>& has) {
    std::optional<MarkHandle> nearest;
    double reach = kHandleReach;
    for (const ShownMark& mark : marks)
        for (std::size_t i = 0; i < mark.placesMm.size(); ++i) {
            const auto at = seenAt(pointer.image, mark.placesMm[i]);
            if (!at || !has(mark, i))
                continue;
            if (const double distance = QLineF(*at, pointer.at).length(); distance <= reach) {
                reach = distance;
                nearest = MarkHandle{mark.id, int(i)};
            }
        }
    return nearest;
}

ShownMark movedTo(const ShownMark& mark, const MarkHandle& handle, const ImagePlace& image, QPointF at) {
    ShownMark moved = mark;
    if (handle.id != mark.id || std::size_t(handle.index) >= mark.placesMm.size())
        return moved;
    dvec3& place = moved.placesMm[std::size_t(handle.index)];
    place = placeUnder(image, at, depthMm(image, place));
    moved.text.clear();
    return moved;
}

}  // namespace pdr::ui
