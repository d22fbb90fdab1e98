#pragma once
/// Where the labels of marks stand: beside their places, without covering one another.

#include <QRectF>
#include <vector>

namespace pdr::ui {

/// A label that is to stand beside a point of the view [px].
struct LabelWish {
    QPointF at;
    QSizeF size;
};

/// Returns a rectangle in `view` for each label, in their order: the nearest of some around its point that covers no
/// earlier label and no point. Where all would, it is to the upper right.
std::vector<QRectF> labelPlaces(const std::vector<LabelWish>& wishes, const QRectF& view);

}  // namespace pdr::ui
