#include "app/looks/value_looks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/base/text.h"
#include "render/volume/histogram.h"

namespace pdr::app {
namespace {

/// Returns the value that parts the voxels between `low` and `high` into two classes whose means lie farthest apart.
double otsuThreshold(const Histogram& histogram, double low, double high) {
    constexpr int kBins = 256;
    const auto edge = [&](int bin) { return std::lerp(low, high, double(bin) / kBins); };
    std::array<double, kBins> counts;
    double total = 0, sum = 0;
    for (int bin = 0; bin < kBins; ++bin) {
        total += counts[std::size_t(bin)] = histogram.count(edge(bin), edge(bin + 1));
        sum += counts[std::size_t(bin)] * bin;
    }
    double below = 0, sumBelow = 0, widest = 0, threshold = low;
    for (int bin = 0; bin < kBins - 1; ++bin) {
        below += counts[std::size_t(bin)];
        sumBelow += counts[std::size_t(bin)] * bin;
        const double above = total - below;
        if (below <= 0 || above <= 0)
            continue;
        const double apart = sumBelow / below - (sum - sumBelow) / above;
        if (const double between = below * above * apart * apart; between > widest) {
            widest = between;
            threshold = edge(bin + 1);
        }
    }
    return threshold;
}

TransferNode greyNode(double value, float opacity, float grey) {
    TransferNode node;
    node.hu = float(std::clamp(value, double(INT16_MIN), double(INT16_MAX)));
    node.opacity = opacity;
    node.albedo = vec3(grey);
    return node;
}

}  // namespace

ValueSpread spreadOf(const Volume& volume) {
    const Histogram histogram(volume);
    ValueSpread spread{histogram.percentile(0.001), 0, histogram.percentile(0.999)};
    spread.high = std::max(spread.high, spread.low + 1);
    spread.threshold = otsuThreshold(histogram, spread.low, spread.high);
    return spread;
}

std::vector<NamedLook> valueLooks(const ValueSpread& spread, const NamedLook& drawn) {
    const double rise = spread.high - spread.threshold;
    NamedLook solid = drawn;
    solid.group = LookGroup::xray;
    solid.name = phrase("Bright values, solid");
    solid.doesNotShow =
        phrase("The curve follows the values of this scan, which are no HU: what is dark in it is not shown.");
    solid.suits = {};
    solid.bloodHu.reset();
    solid.cut.reset();
    solid.model = Model::singleScattering;
    solid.look.visible = {};
    solid.look.transferFunction = {
        2,
        {greyNode(spread.low, 0, 0.4f), greyNode(spread.threshold, 0, 0.4f),
         greyNode(spread.threshold + rise / 4, 0.25f, 0.6f), greyNode(spread.high, 1, 0.9f)}};
    solid.look.window = {float(std::max(spread.low, double(INT16_MIN))),
                         float(std::min(spread.high, double(INT16_MAX)))};
    NamedLook brightest = solid;
    brightest.name = phrase("Brightest values");
    brightest.doesNotShow = phrase("Each pixel shows the highest value along its ray; nothing says how deep it lies.");
    brightest.model = Model::maximumIntensity;
    return {solid, brightest};
}

}  // namespace pdr::app
