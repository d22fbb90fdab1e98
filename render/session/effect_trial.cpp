#include "render/session/effect_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/base/processor_time.h"

namespace pdr {

namespace {

constexpr std::uint32_t kMostIterations = 64;  ///< per measurement
/// Fewest iterations per measurement of an effect: with fewer samples in all, no error is known.
constexpr std::uint32_t kFewestIterations = std::uint32_t(kSamplesToEstimate) / kBandMeasurements + 1;
constexpr int kFewestPixels = 16;  ///< on the longest side of a trial image

/// Returns the iterations per measurement, from the duration of a round with one iteration of each image.
std::uint32_t iterationsFor(double secondsOfARound, double budgetSeconds) {
    const double fitting = budgetSeconds / (kBandMeasurements * std::max(secondsOfARound, 1e-9));
    return std::uint32_t(std::clamp(fitting, 1.0, double(kMostIterations)));
}

Scene sceneWith(const Effect& effect, Scene scene) {
    if (!effect.needed)
        effect.bringIn(scene);
    return scene;
}

Scene sceneWithout(const Effect& effect, Scene scene) {
    if (effect.needed)
        effect.leaveOut(scene);
    return scene;
}

}  // namespace

CostsInTurn::CostsInTurn(std::vector<Iterate> images, double budgetSeconds, std::uint32_t fewest)
    : images_(std::move(images)), budgetSeconds_(budgetSeconds), fewest_(fewest) {}

Result<void> CostsInTurn::first(std::size_t image, const std::stop_token& stop) {
    const auto seconds = images_[image](1, stop);
    if (!seconds)
        return seconds.error();
    firstSeconds_ += *seconds;
    if (++begun_ == images_.size())
        iterations_ = std::max(fewest_, iterationsFor(firstSeconds_, budgetSeconds_ - firstSeconds_));
    return {};
}

Result<void> CostsInTurn::step(const std::stop_token& stop) {
    if (begun_ < images_.size())
        return first(begun_, stop);
    if (rounds_.empty() || rounds_.back().size() == images_.size())
        rounds_.emplace_back();
    const std::size_t turn = rounds_.back().size();
    const auto seconds = images_[rounds_.size() % 2 == 1 ? turn : images_.size() - 1 - turn](iterations_, stop);
    if (!seconds)
        return seconds.error();
    rounds_.back().push_back(1e3 * *seconds / iterations_);
    return {};
}

template <class Value>
CostBand CostsInTurn::bandOfRounds(const Value& value) const {
    std::vector<double> values;
    for (std::size_t round = 0; round < rounds_.size(); ++round)
        values.push_back(value(
            [&](std::size_t image) { return rounds_[round][round % 2 == 0 ? image : images_.size() - 1 - image]; }));
    return bandOf(std::move(values));
}

std::vector<CostBand> CostsInTurn::bands() const {
    std::vector<CostBand> bands;
    for (std::size_t i = 0; i < images_.size(); ++i)
        bands.push_back(bandOfRounds([i](const auto& of) { return of(i); }));
    return bands;
}

CostBand CostsInTurn::added() const {
    return bandOfRounds([](const auto& of) { return of(0) - of(1); });
}

CostBand CostsInTurn::share() const {
    return bandOfRounds([](const auto& of) { return of(0) > 0 ? 1 - of(1) / of(0) : 0; });
}

Result<void> TrialImage::begin() {
    if (film_ && use_ == Use::alone)
        return {};
    if (auto ok = device_.upload(scene_); !ok || film_)
        return ok;
    auto film = device_.film(scene_.film, scene_.revision, scene_.schedule);
    if (!film)
        return film.error();
    film_ = *std::move(film);
    return {};
}

Result<double> TrialImage::accumulate(std::uint32_t n, const std::stop_token& stop) {
    if (auto ok = begin(); !ok)
        return ok.error();
    const double start = processorSeconds();
    if (auto ok = film_->accumulate(n, stop); !ok)
        return ok.error();
    return processorSeconds() - start;
}

Foretold timeWithout(const Foretold& samples, const CostBand& share) {
    constexpr double kLeast = 1e-3;  // nothing is free
    const auto price = [&](double part) { return std::log(std::max(1 - part, kLeast)); };
    const double value = std::log(samples.value) + price(share.middle);
    const double below = std::hypot(std::log(samples.value / samples.low), price(share.middle) - price(share.high));
    const double above = std::hypot(std::log(samples.high / samples.value), price(share.low) - price(share.middle));
    return {std::exp(value), std::exp(value - below), std::exp(value + above)};
}

bool isUnseen(const ImageChange& change) {
    return change.ninetyFifth.high < kUnseenLevels && change.mean.high < kUnseenMean;
}

EffectTrying::EffectTrying(const Effect& effect, const Scene& scene, const DevicePair& devices, double budgetSeconds)
    : EffectTrying(sceneWith(effect, scene), sceneWithout(effect, scene), devices, budgetSeconds) {}

EffectTrying::EffectTrying(const Scene& with, const Scene& without, const DevicePair& devices, double budgetSeconds)
    : with_(with, devices.with, TrialImage::Use::alone),
      without_(without, devices.without, TrialImage::Use::alone),
      costs_({[this](std::uint32_t n, const std::stop_token& stop) { return with_.accumulate(n, stop); },
              [this](std::uint32_t n, const std::stop_token& stop) { return without_.accumulate(n, stop); }},
             budgetSeconds, kFewestIterations) {}

Result<EffectTrial> EffectTrying::trial(const Display& display) const {
    const auto a = with_.film(), b = without_.film();
    if (!a || !b)
        return a ? b.error() : a.error();
    const PixelLook unseen = [](std::size_t, const Moments&) {};
    const auto samples = samplesRatio((*a)->status(display, unseen), (*b)->status(display, unseen));
    const CostBand share = costs_.share();
    return EffectTrial{costs_.added(), share, imageChange(**a, **b, display),
                       samples ? std::optional(timeWithout(*samples, share)) : std::nullopt};
}

Result<ivec2> trialFilm(const Scene& scene, Device& device, int longestSide, double seconds,
                        const std::stop_token& stop) {
    Scene small = scene;
    const auto shrink = [&](int side) {
        small.film = glm::max(scene.film * side / std::max({scene.film.x, scene.film.y, side}), ivec2(1));
    };
    shrink(longestSide);
    TrialImage image(small, device, TrialImage::Use::alone);
    const auto first = image.accumulate(1, stop);
    if (!first)
        return first.error();
    if (*first > seconds)
        shrink(std::max(kFewestPixels, int(std::max(small.film.x, small.film.y) * std::sqrt(seconds / *first))));
    return small.film;
}

}  // namespace pdr
