#include "render/session/live_ledger.h"

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
    return a == b;
}

std::size_t tried(const EffectLedger& ledger) {
    return std::size_t(
        std::ranges::count_if(ledger.effects, [](const TriedEffect& row) { return row.trial && !row.ofViewBefore; }));
}

}  // namespace

void LiveLedger::watch(EffectsWatch watch) {
    watch_ = std::move(watch);
    scene_.reset();
    calibration_.reset();
    with_.reset();
    without_.reset();
    ledger_ = {};
}

void LiveLedger::follow(const Scene& scene, const Display& display) {
    if (!watch_.look || (scene_ && scene_->revision == scene.revision && display_.exposure == display.exposure))
        return;
    const bool known = scene_ && differInViewOnly(*scene_, scene);
    const bool news = !known || tried(ledger_) > 0;
    calibration_.reset();
    if (!known)
        ledger_ = {};
    for (TriedEffect& row : ledger_.effects)
        row.ofViewBefore = row.trial.has_value();
    ledger_.film = ivec2(0);
    ledger_.seconds = 0;
    ledger_.complete = false;
    ledger_.failure.clear();
    scene_ = scene;
    display_ = display;
    begunAt_ = clock_();
    spent_ = 0;
    if (news)
        tell();
}

void LiveLedger::forget() {
    if (!scene_)
        return;
    watch(std::move(watch_));
    tell();
}

bool LiveLedger::hasWork() const {
    return watch_.look && scene_ && !ledger_.complete && ledger_.failure.empty();
}

void LiveLedger::step(const std::stop_token& stop) {
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
        ledger_.failure = done.error().text();
        tell();
    }
    if (!hasWork())
        calibration_.reset();
}

Result<void> LiveLedger::openDevices() {
    for (auto* place : {&with_, &without_})
        if (!*place) {
            auto device = watch_.device();
            if (!device)
                return device.error();
            *place = *std::move(device);
        }
    return {};
}

Result<void> LiveLedger::measure(const std::stop_token& stop) {
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
void LiveLedger::takeRows() {
    EffectLedger now = calibration_->ledger();
    if (!ledger_.effects.empty() && ledger_.film == now.film && tried(ledger_) == tried(now) && !now.complete)
        return;
    for (std::size_t i = 0; i < std::min(now.effects.size(), ledger_.effects.size()); ++i)
        if (TriedEffect& row = now.effects[i]; !row.trial && row.canBeTried()) {
            row.trial = ledger_.effects[i].trial;
            row.ofViewBefore = row.trial.has_value();
        }
    ledger_ = std::move(now);
    tell();
}

void LiveLedger::tell() const {
    if (watch_.look)
        watch_.look(std::make_shared<const EffectLedger>(ledger_));
}

}  // namespace pdr
