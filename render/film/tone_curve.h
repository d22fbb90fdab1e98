#pragma once
/// The tone curves before they are rounded, read from tables. They give the same bits on every device, which calls of
/// exp or pow do not, at the price of a few multiplications. With x = radiance / exposure of a channel:
///   perChannel  1 - exp(-x), each channel alone
///   keepsHue    of the largest channel p n = 1 - exp(-p), of the others n x / p; then all move towards white by the
///               share g = 1 - 1 / (1 + k (p - n)): n ((1 - g) x / p + g), k = 0.12
/// then the sRGB curve (IEC 61966-2-1), times 255. Both show greys alike. keepsHue is continuous; none of its channels
/// exceeds n < 1, so that nothing is clipped; a colour that gets brighter gets brighter in each channel; and the level
/// of the largest channel depends on that channel alone.

#include <cstdint>

#include "render/base/lanes.h"

namespace pdr {

inline constexpr double kWhitening = 0.12;  ///< k; larger: bright colours are paler

/// A table of a function has kCurvePerOctave entries per octave from 2^kFrom to 2^kTo; the upper bits of a float are
/// the index.
inline constexpr int kCurveBits = 6, kCurvePerOctave = 1 << kCurveBits;
template <int kFrom, int kTo>
struct OctaveTable {
    static constexpr int kBegin = kFrom, kEntries = (kTo - kFrom) * kCurvePerOctave + 1;

    /// Returns the function at x in [2^kFrom, 2^kTo), between two entries along their chord.
    template <class T>
    PDR_HD static T at(const T* table, float x) {
        constexpr int kShift = 23 - kCurveBits;
        constexpr std::uint32_t kFirst = std::uint32_t(127 + kFrom) << kCurveBits;
        const std::uint32_t bits = std::uint32_t(bitsOf(x));
        const T* entry = table + ((bits >> kShift) - kFirst);
        const float place = float(bits & ((1u << kShift) - 1)) * (1.0f / (1u << kShift));
        return entry[0] + (entry[1] - entry[0]) * place;
    }
};

/// The level of a grey by its radiance in units of the exposure.
using GreyTable = OctaveTable<-20, 4>;
/// By the largest channel p, in units of the exposure: the light that keepsHue shows of a channel x of that pixel is
/// `x` of the entry times x, plus `y` of the entry.
using HueTable = OctaveTable<-20, 20>;
/// The level of light that is shown, in [0, 1].
using LightTable = OctaveTable<-20, 0>;

/// Return the tables in the memory of the host.
const float* displayCurve();  ///< GreyTable
const vec2* hueCurve();       ///< HueTable
const float* lightCurve();    ///< LightTable

/// Returns the level of `fraction`, a radiance in units of the exposure: [0, 255], off by less than 0.005. 0 for what
/// is not above 0.
PDR_HD inline float exactLevelOf(const float* curve, float fraction) {
    if (!(fraction > 0))
        return 0;
    if (fraction < 0x1p-20f)  // straight from there to black
        return fraction * 0x1p20f * curve[0];
    return fraction < 16 ? GreyTable::at(curve, fraction) : 255;
}

/// Returns the level of light that is shown, from `curve`, a LightTable: [0, 255], off by less than 0.005.
PDR_HD inline float exactLevelOfLight(const float* curve, float light) {
    if (light < 0x1p-20f)
        return light * 0x1p20f * curve[0];
    return light < 1 ? LightTable::at(curve, light) : 255;
}

/// Returns what keepsHue does to the pixels whose largest channel is p > 0, from `curve`; see HueTable.
PDR_HD inline vec2 hueAt(const vec2* curve, float p) {
    if (p < 0x1p-20f)
        return {1, 0};
    return p < 0x1p20f ? HueTable::at(curve, p) : vec2(0, 1);
}

}  // namespace pdr
