#include "render/accuracy/bias.h"

#include <algorithm>

#include "render/accuracy/bias_text.h"
#include "render/film/health_text.h"
#include "render/film/levels_text.h"

namespace pdr {
namespace {

struct Shortcut {
    BiasCause cause;
    Text text;
};

/// Returns the shortcuts in use. Only a measurement tells what they do to an image.
std::vector<Shortcut> shortcuts(const BiasFacts& facts) {
    std::vector<Shortcut> all;
    if (facts.estimator == Estimator::kroesMarch)
        all.push_back({BiasCause::march, phrase("march of 3 voxels")});
    if (facts.schedule.kind == Schedule::Kind::kroes && facts.schedule.filter)
        all.push_back({BiasCause::blur, phrase("each iteration blurred")});
    if (facts.texturesFilter)
        all.push_back({BiasCause::fastFilter, phrase("fast filter")});
    return all;
}

BiasCause causeOf(Fault fault) {
    switch (fault) {
        case Fault::overMajorant:
            return BiasCause::overBound;
        case Fault::cutPath:
            return BiasCause::bounceCap;
        case Fault::overTolerance:
            return BiasCause::overTolerance;
        default:
            return BiasCause::leftOut;
    }
}

/// Returns the bias due to a fault. Each faulty sample belongs to one pixel, so their count bounds the number of
/// pixels.
Bias faultBias(Fault fault, const BiasFacts& facts) {
    const std::uint64_t count = facts.health.of(fault).count;
    Bias bias{.cause = causeOf(fault), .text = phrase("%1 %2", count, faultText(fault)), .fault = fault};
    if (facts.tissuePixels > 0 && count < facts.tissuePixels) {
        bias.shareAtMost = double(count) / double(facts.tissuePixels);
        bias.text = phrase("%1: %2", bias.text, shareText(*bias.shareAtMost));
    }
    return bias;
}

Bias smoothingBias(const std::optional<DenoisedError>& error) {
    if (!error)
        return {BiasCause::smoothing, phrase("denoised: how much is not known yet")};
    return {.cause = BiasCause::smoothing,
            .text = phrase("denoised: 95 % of the tissue within ±%1 levels, noise included",
                           levelsText(error->levelsAtMost)),
            .levelsAtMost = error->levelsAtMost};
}

Text sizeText(ivec2 size) {
    return phrase("%1 × %2", size.x, size.y);
}

Text measuredOr(const std::optional<MeasuredBias>& measured) {
    return measured ? measuredText(*measured) : phrase("how much is not known yet");
}

Bias quadratureBias(const BiasFacts& facts) {
    const auto& measured = facts.measured.quadrature;
    const Text atMost = phrase("sums along rays: at most ±%1 levels", levelsText(facts.toleranceLevels));
    return {.cause = BiasCause::quadrature,
            .text = measured ? phrase("%1; measured: %2", atMost, measuredText(*measured)) : atMost,
            .measured = measured,
            .levelsAtMost = facts.toleranceLevels};
}

void addOfComputing(const BiasFacts& facts, std::vector<Bias>& all) {
    if (const std::vector<Shortcut> together = shortcuts(facts); !together.empty())  // measured together
        all.push_back({together.front().cause,
                       phrase("%1: %2", shortcutNames(facts), measuredOr(facts.measured.shortcuts)),
                       facts.measured.shortcuts});
    if (keepsRunningMean(facts))
        all.push_back({BiasCause::runningMean,
                       phrase("mean kept in single precision: %1", measuredOr(facts.measured.runningMean)),
                       facts.measured.runningMean});
    if (sumsToATolerance(facts))
        all.push_back(quadratureBias(facts));
    if (!facts.denseWarning.empty())
        all.push_back({BiasCause::overDense, facts.denseWarning});
    for (int i = 0; i < kFaults; ++i)
        if (facts.health.of(Fault(i)).count > 0)
            all.push_back(faultBias(Fault(i), facts));
    if (facts.isDenoised)
        all.push_back(smoothingBias(facts.denoised));
}

}  // namespace

const char* biasName(BiasCause cause) {
    constexpr const char* kNames[] = {"march",     "blur",       "fastFilter",        "runningMean", "quadrature",
                                      "overDense", "leftOut",    "overBound",         "bounceCap",   "overTolerance",
                                      "smoothing", "resolution", "interpolatedSlices"};
    return kNames[int(cause)];
}

bool isOfComputing(BiasCause cause) {
    return cause < BiasCause::resolution;
}

Text shortcutNames(const BiasFacts& facts) {
    Text names;
    for (const Shortcut& shortcut : shortcuts(facts))
        names = names.empty() ? shortcut.text : phrase("%1, %2", names, shortcut.text);
    return names;
}

bool keepsRunningMean(const BiasFacts& facts) {
    return facts.schedule.kind == Schedule::Kind::kroes && facts.schedule.runningMean;
}

bool sumsToATolerance(const BiasFacts& facts) {
    return isProjection(facts.model) && facts.model != Model::maximumIntensity;
}

std::vector<Bias> biases(const BiasFacts& facts) {
    std::vector<Bias> all;
    addOfComputing(facts, all);
    if (facts.view != ivec2(0) && facts.image != facts.view)
        all.push_back(
            {BiasCause::resolution, phrase("%1 pixels stretched to %2", sizeText(facts.image), sizeText(facts.view))});
    if (facts.slicesInterpolated)
        all.push_back({BiasCause::interpolatedSlices,
                       phrase("slices between the scan's own are a cubic's: a choice, and no error of the computing")});
    return all;
}

bool noneOfComputing(const std::vector<Bias>& biases) {
    return std::ranges::none_of(biases, [](const Bias& bias) { return isOfComputing(bias.cause); });
}

}  // namespace pdr
