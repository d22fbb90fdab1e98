#include "app/jobs/model_trial.h"

#include "render/device/device.h"
#include "render/session/effect_trial.h"

namespace pdr::app {
namespace {

constexpr int kLongestSide = 160;              ///< longest side of the small image [pixels]
constexpr double kSeconds = 1.5;               ///< processor time for the measurement, about
constexpr double kSecondsPerIteration = 0.02;  ///< maximum processor time of an iteration

/// Measures the difference; returns nothing if it was cancelled or failed.
std::optional<EffectTrial> tried(Scene scene, Model before, const Display& display, const std::stop_token& stop) {
    const auto one = makeCpuDevice(1), other = makeCpuDevice(1);
    const auto film = trialFilm(scene, *one, kLongestSide, kSecondsPerIteration, stop);
    if (!film || stop.stop_requested())
        return std::nullopt;
    scene.film = *film;
    Scene without = scene;
    without.model = before;
    EffectTrying trying(scene, without, {*one, *other}, kSeconds);
    while (!trying.isDone())
        if (!trying.step(stop) || stop.stop_requested())
            return std::nullopt;
    const auto trial = trying.trial(display);
    return trial ? std::optional(*trial) : std::nullopt;
}

}  // namespace

void ModelTrial::measure(const Scene& scene, Model before, const Display& display) {
    start([this, scene, before, display](const Progress&, const std::stop_token& stop) -> std::function<void()> {
        const auto trial = tried(scene, before, display, stop);
        if (!trial || !(trial->share.middle < 1))
            return [] {};
        const double factor = 1 / (1 - trial->share.middle), levels = trial->change.ninetyFifth.high;
        return [this, model = scene.model, before, factor, levels] { emit measured(model, before, factor, levels); };
    });
}

}  // namespace pdr::app
