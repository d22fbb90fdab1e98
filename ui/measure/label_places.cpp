#include "ui/measure/label_places.h"

#include <algorithm>

namespace pdr::ui {
namespace {

constexpr double kReaches[] = {8, 24, 44, 68, 96};  ///< distances of a label from its point [px]
constexpr double kPointSize = 8;                    ///< what is kept free about a point [px]

/// Directions in which a label is tried, the most usual first.
constexpr QPointF kDirections[] = {{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}};

/// Returns the rectangle whose nearest corner or side lies `reach` off `at` in that direction.
QRectF beside(QPointF at, QSizeF size, QPointF direction, double reach) {
    const QPointF centre(at.x() + direction.x() * (reach + size.width() / 2),
                         at.y() + direction.y() * (reach + size.height() / 2));
    return {centre - QPointF(size.width(), size.height()) / 2, size};
}

}  // namespace

std::vector<QRectF> labelPlaces(const std::vector<LabelWish>& wishes, const QRectF& view) {
    std::vector<QRectF> taken, labels;
    for (const LabelWish& wish : wishes)
        taken.emplace_back(wish.at - QPointF(kPointSize, kPointSize) / 2, QSizeF(kPointSize, kPointSize));
    const auto isFree = [&](const QRectF& label) {
        return view.contains(label) &&
               std::ranges::none_of(taken, [&](const QRectF& other) { return other.intersects(label); });
    };
    const auto placeOf = [&](const LabelWish& wish) {
        for (const double reach : kReaches)
            for (const QPointF direction : kDirections)
                if (const QRectF label = beside(wish.at, wish.size, direction, reach); isFree(label))
                    return label;
        return beside(wish.at, wish.size, kDirections[0], kReaches[0]);
    };
    for (const LabelWish& wish : wishes)
        taken.push_back(labels.emplace_back(placeOf(wish)));
    return labels;
}

}  // namespace pdr::ui
