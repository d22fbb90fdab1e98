#include "render/film/tone_curve.h"

#include <array>
#include <cmath>

#include "render/base/srgb.h"

namespace pdr {
namespace {

/// Returns the table of `function`, which takes and returns what it says in double.
template <class Table, class T, class Function>
std::array<T, Table::kEntries> tableOf(const Function& function) {
    std::array<T, Table::kEntries> table{};
    for (int i = 0; i < Table::kEntries; ++i) {
        const double octave = std::exp2(Table::kBegin + i / kCurvePerOctave);
        table[std::size_t(i)] = T(function(octave * (1 + double(i % kCurvePerOctave) / kCurvePerOctave)));
    }
    return table;
}

dvec2 hueEntry(double p) {
    const double n = -std::expm1(-p), coloured = 1 / (1 + kWhitening * (p - n));
    return {n / p * coloured, n * (1 - coloured)};
}

}  // namespace

const float* displayCurve() {
    static const auto table =
        tableOf<GreyTable, float>([](double fraction) { return 255 * srgbFromLinear(-std::expm1(-fraction)); });
    return table.data();
}

const vec2* hueCurve() {
    static const auto table = tableOf<HueTable, vec2>(hueEntry);
    return table.data();
}

const float* lightCurve() {
    static const auto table = tableOf<LightTable, float>([](double light) { return 255 * srgbFromLinear(light); });
    return table.data();
}

}  // namespace pdr
