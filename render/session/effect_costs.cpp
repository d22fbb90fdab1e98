#include "render/session/effect_costs.h"

#include <algorithm>
#include <utility>

#include "render/base/processor_time.h"

namespace pdr {

namespace {

/// Iterations that each measurement should have: fewer say little about the image.
constexpr int kWantedIterations = 8;

}  // namespace

bool TriedEffect::couldBeLeftOut() const {
    return effect.needed && trial && verdictOf(trial->share) != CostVerdict::saves && isUnseen(trial->change);
}

Calibration::Calibration(Scene scene, const Display& display, const DevicePair& devices, const Effort& effort)
    : scene_(std::move(scene)), display_(display), devices_(devices), effort_(effort) {
    effectCosts_.device = devices_.with.info();
    effectCosts_.model = scene_.model;
    for (Effect& effect : needs(scene_))
        effectCosts_.effects.push_back({std::move(effect), std::nullopt});
}

double Calibration::secondsEach() const {
    const auto tried = std::ranges::count_if(effectCosts_.effects, &TriedEffect::canBeTried);
    return effort_.seconds / double(std::max<std::ptrdiff_t>(tried, 1));
}

Result<void> Calibration::step(const std::stop_token& stop) {
    const double start = processorSeconds();
    Result<void> done = effectCosts_.film == ivec2(0) ? chooseFilm(stop) : tryNext(stop);
    effectCosts_.seconds += processorSeconds() - start;
    return done;
}

Result<void> Calibration::chooseFilm(const std::stop_token& stop) {
    const auto film = trialFilm(scene_, devices_.with, effort_.longestSide,
                                secondsEach() / (2 * kBandMeasurements * kWantedIterations), stop);
    if (!film)
        return film.error();
    effectCosts_.film = scene_.film = *film;
    return {};
}

Result<void> Calibration::tryNext(const std::stop_token& stop) {
    while (next_ < effectCosts_.effects.size() && !effectCosts_.effects[next_].canBeTried())
        ++next_;
    effectCosts_.complete = next_ == effectCosts_.effects.size();
    if (effectCosts_.complete)
        return {};
    TriedEffect& tried = effectCosts_.effects[next_];
    if (!trying_)
        trying_ = std::make_unique<EffectTrying>(tried.effect, scene_, devices_, secondsEach());
    if (auto ok = trying_->step(stop); !ok || stop.stop_requested() || !trying_->isDone())
        return ok;
    const auto trial = trying_->trial(display_);
    if (!trial)
        return trial.error();
    tried.trial = *trial;
    trying_.reset();
    ++next_;
    return {};
}

}  // namespace pdr
