#pragma once
/// Contrast of two colours by WCAG 2.2: relative luminance and contrast ratio, [1, 21].

#include <QColor>
#include <algorithm>
#include <cmath>

namespace pdr::test {

/// Returns the linear light of an sRGB value, both in [0, 1].
inline double linearLight(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

inline double luminance(const QColor& colour) {
    return 0.2126 * linearLight(double(colour.redF())) + 0.7152 * linearLight(double(colour.greenF())) +
           0.0722 * linearLight(double(colour.blueF()));
}

inline double contrast(const QColor& a, const QColor& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

}  // namespace pdr::test
