#pragma once
/// Curves that two numbers say, beside those of free points.

#include <QString>
#include <array>

#include "render/scene/edit/curve.h"
#include "render/volume/histogram.h"

namespace pdr::ui {

struct CurveShape {
    enum class Kind { window, threshold, bell, percentiles };
    Kind kind = Kind::window;
    /// Level and width, the threshold alone, centre and width [HU]; or from which to which percentage of the voxels.
    double first = 0, second = 0;

    bool operator==(const CurveShape&) const = default;
};

/// What one of the numbers is.
struct ShapeNumber {
    QString name, unit;
    double lowest, highest;
};

/// The numbers of a kind: one or two.
QList<ShapeNumber> numbersOf(CurveShape::Kind kind);

/// The curve, as high as `top`. Percentiles need the histogram.
Curve curveOf(const CurveShape& shape, float top, const Histogram& histogram);

/// Of that kind, near to what `curve` shows: it begins and ends where the curve does most of its rise.
CurveShape shapeLike(const Curve& curve, CurveShape::Kind kind, const Histogram& histogram);

}  // namespace pdr::ui
