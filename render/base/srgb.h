#pragma once
/// The transfer function of sRGB (IEC 61966-2-1), without its rounding to levels.

#include <cmath>

namespace pdr {

/// Returns the linear light of an encoded value, both in [0, 1].
inline double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Returns the encoded value of linear light, both in [0, 1].
inline double srgbFromLinear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace pdr
