#include "ui/tissue/curve_shape.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "render/scene/edit/curve_shapes.h"
#include "ui/text/value_text.h"

namespace pdr::ui {
namespace {

QString text(const char* english) {
    return QCoreApplication::translate("CurveShape", english);
}

double percentOf(const Histogram& histogram, double hu) {
    return histogram.total() > 0 ? 100 * histogram.count(double(kLowestHu) - 1, hu) / histogram.total() : 0;
}

}  // namespace

QList<ShapeNumber> numbersOf(CurveShape::Kind kind, const ValueUnit& values) {
    const QString unit = ' ' + unitName(values);
    const auto place = [&](const char* name) {
        return ShapeNumber{text(name),
                           unit,
                           values.valueOf(double(kLowestHu)),
                           values.valueOf(double(kHighestHu)),
                           values.decimals(),
                           values.step,
                           values.zero};
    };
    const auto width = [&](double lowest) {
        return ShapeNumber{text("Width"),     unit,       lowest * values.step, values.step * double(kHighestHu),
                           values.decimals(), values.step};
    };
    const auto percent = [](const char* name) { return ShapeNumber{text(name), text(" %"), 0, 100, 1}; };
    switch (kind) {
        case CurveShape::Kind::threshold:
            return {place("From")};
        case CurveShape::Kind::bell:
            return {place("Centre"), width(1)};
        case CurveShape::Kind::percentiles:
            return {percent("From"), percent("To")};
        default:
            return {place("Level"), width(0)};
    }
}

Curve curveOf(const CurveShape& shape, float top, const Histogram& histogram) {
    const auto window = [&](double low, double high) {
        return windowCurve(float((low + high) / 2), float(std::max(high - low, 0.0)), top);
    };
    switch (shape.kind) {
        case CurveShape::Kind::threshold:
            return thresholdCurve(float(shape.first), top);
        case CurveShape::Kind::bell:
            return bellCurve(float(shape.first), float(shape.second), top);
        case CurveShape::Kind::percentiles:
            return window(histogram.percentile(shape.first / 100), histogram.percentile(shape.second / 100));
        default:
            return windowCurve(float(shape.first), float(shape.second), top);
    }
}

CurveShape shapeLike(const Curve& curve, CurveShape::Kind kind, const Histogram& histogram) {
    const float top = heightOf(curve);
    const auto reaches = [&](float part) { return double(std::round(firstAt(curve, part * top))); };
    const double low = reaches(0.05f), high = reaches(0.95f);
    const auto rounded = [](double percent) { return std::round(10 * percent) / 10; };  // as shown
    switch (kind) {
        case CurveShape::Kind::threshold:
            return {kind, reaches(0.5f), 0};
        case CurveShape::Kind::bell:
            return {kind, high, std::max(high - low, 20.0)};
        case CurveShape::Kind::percentiles:
            return {kind, rounded(percentOf(histogram, low)), rounded(percentOf(histogram, high))};
        default:
            return {kind, (low + high) / 2, high - low};
    }
}

}  // namespace pdr::ui
