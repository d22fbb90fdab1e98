#include "render/slice/window_presets.h"

#include <algorithm>

#include "render/volume/histogram.h"

namespace pdr {

std::span<const WindowPreset> windowPresets() {
    static constexpr WindowPreset kPresets[] = {
        {'1', "soft tissue", {50, 350}}, {'2', "abdomen", {40, 350}},     {'3', "brain", {40, 80}},
        {'4', "bone", {400, 1000}},      {'4', "hard bone", {350, 2000}}, {'5', "lung", {-600, 1500}},
        {'6', "vessels", {300, 600}},    {'7', "mediastinum", {80, 400}}, {'8', "temporal bone", {700, 4000}}};
    return kPresets;
}

GreyWindow wholeRange(const Volume& volume) {
    const Histogram histogram(volume);
    const double low = histogram.percentile(0.001), high = histogram.percentile(0.999);
    return {(low + high) / 2, std::max(high - low, 1.0), VoiFunction::linearExact};
}

}  // namespace pdr
