#include "render/session/live_effect_costs.h"

#include <algorithm>
#include <utility>

#include "render/base/thrown.h"

namespace pdr {

namespace {

constexpr Calibration::Effort kEffort{.longestSide = 96, .seconds = 3};

/// Returns whether both are one scene seen from different views. Lights may differ, because they may follow the camera.
bool differInViewOnly(Scene a, const Scene& b) {
    a.camera = b.camera;
    a.lights = b.lights;
    a.film = b.film;
    a.revision = b.revision;
    a.lookName = b.lookName;
    a.maskAwaited = b.maskAwaited;
    a.ctDenoised = b.ctDenoised;
    return a == b;
}

std::size_t tried(const EffectCosts& effectCosts) {
    return std::size_t(std::ranges::count_if(effectCosts.effects,
                                             [](const TriedEffect& row) { return row.trial && !row.ofViewBefore; }));
}

}  // namespace

void LiveEffectCosts::watch(EffectsWatch watch) {
    watch_ = std::move(watch);
    scene_.reset();
    calibration_.reset();
    with_.reset();
    without_.reset();
    effectCosts_ = {};
}

void LiveEffectCosts::follow(const Scene& scene, const Display& display) {
    if (!watch_.look || (scene_ && scene_->revision == scene.revision && Tone(display_) == Tone(display)))
        return;
    const bool known = scene_ && differInViewOnly(*scene_, scene);
    const bool news = !known || tried(effectCosts_) > 0;
    calibration_.reset();
    if (!known)
        effectCosts_ = {};
    for (TriedEffect& row : effectCosts_.effects)
        row.ofViewBefore = row.trial.has_value();
    effectCosts_.film = ivec2(0);
    effectCosts_.seconds = 0;
    effectCosts_.complete = false;
    effectCosts_.failure.clear();
    scene_ = scene;
    display_ = display;
    begunAt_ = clock_();
    spent_ = 0;
    if (news)
        tell();
}

void LiveEffectCosts::forget() {
    if (!scene_)
        return;
    watch(std::move(watch_));
    tell();
}

bool LiveEffectCosts::hasWork() const {
    return watch_.look && scene_ && !effectCosts_.complete && effectCosts_.failure.empty();
}

void LiveEffectCosts::step(const std::stop_token& stop) {
    const double start = clock_();
    Result<void> done;
    try {
        done = measure(stop);
    } catch (...) {
        done = thrownError();
    }
    spent_ += clock_() - start;
    if (stop.stop_requested()) {
        calibration_.reset();
        return;
    }
    if (!done) {
        effectCosts_.failure = done.error().text();
        tell();
    }
    if (!hasWork())
        calibration_.reset();
}

Result<void> LiveEffectCosts::openDevices() {
    for (auto* place : {&with_, &without_})
        if (!*place) {
            auto device = watch_.device();
            if (!device)
                return device.error();
            *place = *std::move(device);
        }
    return {};
}

Result<void> LiveEffectCosts::measure(const std::stop_token& stop) {
    if (auto ok = openDevices(); !ok)
        return ok;
    if (!calibration_)
        calibration_ = std::make_unique<Calibration>(*scene_, display_, DevicePair{*with_, *without_}, kEffort);
    else if (auto ok = calibration_->step(stop); !ok || stop.stop_requested())
        return ok;
    takeRows();
    return {};
}

/// Takes over the calibration's rows, and reports them, if there is something new. A row that is not measured yet keeps
/// the result of the earlier view.
void LiveEffectCosts::takeRows() {
    EffectCosts now = calibration_->effectCosts();
    if (!effectCosts_.effects.empty() && effectCosts_.film == now.film && tried(effectCosts_) == tried(now) &&
        !now.complete)
        return;
    for (std::size_t i = 0; i < std::min(now.effects.size(), effectCosts_.effects.size()); ++i)
        if (TriedEffect& row = now.effects[i]; !row.trial && row.canBeTried()) {
            row.trial = effectCosts_.effects[i].trial;
            row.ofViewBefore = row.trial.has_value();
        }
    effectCosts_ = std::move(now);
    tell();
}

void LiveEffectCosts::tell() const {
    if (watch_.look)
        watch_.look(std::make_shared<const EffectCosts>(effectCosts_));
}

}  // namespace pdr
