#pragma once
/// Curve shapes that are defined by two numbers, as opposed to free points.

#include <QString>
#include <array>

#include "render/scene/edit/curve.h"
#include "render/volume/histogram.h"
#include "render/volume/value_unit.h"

namespace pdr::ui {

struct CurveShape {
    enum class Kind { window, threshold, bell, percentiles };
    Kind kind = Kind::window;
    /// Level and width, the threshold alone, centre and width [HU]; or the lower and upper percentage of the voxels.
    double first = 0, second = 0;

    bool operator==(const CurveShape&) const = default;
};

/// The description of one of the numbers, as it is shown: `step` times the number of the shape, plus `zero`.
struct ShapeNumber {
    QString name, unit;
    double lowest, highest;
    int decimals = 0;
    double step = 1, zero = 0;
};

/// Returns the numbers of a kind, one or two, in the unit of `values`.
QList<ShapeNumber> numbersOf(CurveShape::Kind kind, const ValueUnit& values = {});

/// Returns the curve, whose highest value is `top`. Percentiles need the histogram.
Curve curveOf(const CurveShape& shape, float top, const Histogram& histogram);

/// Returns a shape of that kind close to `curve`: it begins and ends where the curve does most of its rise.
CurveShape shapeLike(const Curve& curve, CurveShape::Kind kind, const Histogram& histogram);

}  // namespace pdr::ui
