#include "ui/slices/plane_pen.h"

namespace pdr::ui {

QPen planePen(AnatomicalPlane plane) {
    constexpr double kWidth = 1.2;  // [px]
    switch (plane) {
        case AnatomicalPlane::axial:
            return {QColor(235, 80, 80), kWidth, Qt::SolidLine};
        case AnatomicalPlane::coronal:
            return {QColor(90, 200, 90), kWidth, Qt::DashLine};
        case AnatomicalPlane::sagittal:
            break;
    }
    return {QColor(235, 200, 70), kWidth, Qt::DotLine};
}

}  // namespace pdr::ui
