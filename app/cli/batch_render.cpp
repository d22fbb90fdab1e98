#include "app/cli/batch_render.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/accuracy/prediction.h"

namespace pdr::app {
namespace {

constexpr double kLaunchSeconds = 0.25;  ///< so that Ctrl-C and --seconds are obeyed soon
constexpr double kReportSeconds = 0.5;
constexpr std::uint64_t kErrorEvery = 16;  ///< samples between two looks at the error; fewer tell too little about it

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Result<BatchResult> BatchRender::run(std::stop_token stop, const Report& report) {
    const auto start = std::chrono::steady_clock::now();
    double elapsed = 0;
    double reported = -kReportSeconds;
    std::optional<StopReason> reason;
    while (!reason) {
        if (auto ok = takeSamples(elapsed, stop); !ok)
            return ok.error();
        elapsed = secondsSince(start);
        reason = stop.stop_requested() ? StopReason::interrupted : reached(elapsed);
        if (reason || elapsed - reported >= kReportSeconds) {
            report(state(elapsed));
            reported = elapsed;
        }
    }
    return BatchResult{*reason, film_.status(), elapsed};
}

Result<void> BatchRender::takeSamples(double elapsed, std::stop_token stop) {
    const Tile whole{0, 0, film_.size().x, film_.size().y};
    const SampleRange range = film_.nextSamples(wantedSamples(elapsed));
    // A launch that is broken off leaves worthless sums: only the first one has nothing to lose.
    const bool first = film_.samplesPerPixel() == 0;
    if (auto ok = device_.render(whole, range, film_.sums(whole), first ? stop : std::stop_token()); !ok)
        return ok;
    if (!(first && stop.stop_requested()))
        film_.commit(range);
    return {};
}

std::uint32_t BatchRender::wantedSamples(double elapsed) const {
    const std::uint64_t done = film_.samplesPerPixel();
    if (done == 0)
        return 1;
    double time = kLaunchSeconds;
    if (stops_.seconds)
        time = std::min(time, *stops_.seconds - elapsed);
    double wanted = std::floor(time * double(done) / std::max(elapsed, 1e-9));
    if (stops_.samples)
        wanted = std::min(wanted, double(*stops_.samples - done));
    if (stops_.relativeError)
        wanted = std::min(wanted, double(kErrorEvery - done % kErrorEvery));
    return std::uint32_t(std::clamp(wanted, 1.0, double(kSamplesPerBlock)));
}

std::optional<StopReason> BatchRender::reached(double elapsed) const {
    const std::uint64_t done = film_.samplesPerPixel();
    if (stops_.samples && done >= *stops_.samples)
        return StopReason::samples;
    if (stops_.relativeError && done % kErrorEvery == 0 && film_.status().relativeError <= *stops_.relativeError)
        return StopReason::error;
    if (stops_.seconds && elapsed >= *stops_.seconds)
        return StopReason::seconds;
    return std::nullopt;
}

BatchState BatchRender::state(double elapsed) const {
    BatchState state{film_.status(), elapsed, 0, std::nullopt};
    if (stops_.samples)
        state.fraction = std::max(state.fraction, double(film_.samplesPerPixel()) / double(*stops_.samples));
    if (stops_.seconds)
        state.fraction = std::max(state.fraction, elapsed / *stops_.seconds);
    if (stops_.relativeError)
        state.fraction = std::max(state.fraction,
                                  double(film_.samplesPerPixel()) / samplesToReach(*stops_.relativeError, state.film));
    state.fraction = std::min(state.fraction, 1.0);
    if (state.fraction > 0)
        state.secondsLeft = elapsed * (1 - state.fraction) / state.fraction;
    return state;
}

}  // namespace pdr::app
