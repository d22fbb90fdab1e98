#pragma once
/// The curve of tone_map.h before it is rounded, read from a table. It gives the same bits on every device, which
/// calls of exp or pow do not, at the price of a multiplication.

#include <cstdint>

#include "render/base/lanes.h"

namespace pdr {

/// The table has kCurvePerOctave entries per octave of radiance, in units of the exposure, from 2^kCurveFrom to
/// 2^kCurveTo; the upper bits of a float are the index.
inline constexpr int kCurveFrom = -20, kCurveTo = 4, kCurveBits = 6, kCurvePerOctave = 1 << kCurveBits;
inline constexpr int kCurveEntries = (kCurveTo - kCurveFrom) * kCurvePerOctave + 1;

/// Returns the table: kCurveEntries levels.
const float* displayCurve();

/// Returns the level of `fraction`, a radiance in units of the exposure: [0, 255], off by less than 0.005. 0 for what
/// is not above 0.
PDR_HD inline float exactLevelOf(const float* curve, float fraction) {
    constexpr int kShift = 23 - kCurveBits;
    constexpr std::uint32_t kFirst = std::uint32_t(127 + kCurveFrom) << kCurveBits;
    if (!(fraction > 0))
        return 0;
    if (fraction < 0x1p-20f)  // straight from there to black
        return fraction * 0x1p20f * curve[0];
    if (!(fraction < 16))
        return 255;
    const std::uint32_t bits = std::uint32_t(bitsOf(fraction));
    const float* entry = curve + ((bits >> kShift) - kFirst);
    const float place = float(bits & ((1u << kShift) - 1)) * (1.0f / (1u << kShift));
    return entry[0] + (entry[1] - entry[0]) * place;
}

}  // namespace pdr
