#include "render/session/batch_render.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace pdr {
namespace {

constexpr double kReportSeconds = 0.5;
constexpr std::uint64_t kMostWholeOrder = 1 << 20;
/// The error is read after multiples of so many samples, and after whole blocks only from kWholeLooks on.
constexpr std::uint64_t kErrorEvery = 16, kWholeLooks = 512;
/// Errors of nearly all scenes fall no faster than n^-0.7 with the samples n: two deviations from the usual exponent
/// (accuracy/forecast.cpp). Most growth of n from one reading to the next.
constexpr double kSteepestFall = 0.7, kMostGrowth = 4;

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
        const auto told = [&](const SampleCounts& counts) {
            elapsed = secondsSince(start);
            if (elapsed - reported < kReportSeconds)
                return;
            report(state(elapsed, counts));
            reported = elapsed;
        };
        if (auto ok = takeSamples(elapsed, stop, told); !ok)
            return ok.error();
        elapsed = secondsSince(start);
        const bool reports = elapsed - reported >= kReportSeconds;
        if (reports || errorIsDue())
            if (auto ok = look(); !ok)
                return ok.error();
        reason = stop.stop_requested() ? StopReason::interrupted : reached(elapsed);
        if (reason && isFilmRight(*reason))
            if (auto ok = look(); !ok)
                return ok.error();
        if (!reason && errorIsDue())
            planLook();
        if (reason || reports) {
            report(state(elapsed, {done_, done_, double(done_)}));
            reported = elapsed;
        }
    }
    return BatchResult{*reason, status_, elapsed};
}

bool BatchRender::isFilmRight(StopReason reason) const {
    return done_ > 0 && !(reason == StopReason::interrupted && whenStopped_ == WhenStopped::discard);
}

bool BatchRender::errorIsDue() const {
    return stopsByError() && done_ >= nextLook_;
}

/// Plans the next reading of the error: where the limit is reached at the earliest. All that this depends on are
/// samples and errors at readings, and so does the end of the image.
void BatchRender::planLook() {
    double growth = kMostGrowth;
    const auto earliest = [&](const std::optional<double>& target, double error) {
        if (target)
            growth = std::min(growth, std::pow(std::max(error / *target, 1.0), 1 / kSteepestFall));
    };
    earliest(stops_.relativeError, status_.relativeError);
    earliest(stops_.levels, status_.displayError);
    const std::uint64_t step = done_ < kWholeLooks ? kErrorEvery : kSamplesPerBlock;
    const std::uint64_t steps = std::uint64_t(std::ceil(growth * double(done_) / double(step)));
    nextLook_ = std::max(steps * step, done_ + step);
}

/// Keeps what a stop request has left of a film that was extended tile by tile; a tile without samples gets one.
Result<void> BatchRender::keepFinished(std::uint64_t there) {
    double mean = 0;
    if (auto ok = film_.look([&](const Film& film) { mean = film.samples().mean; }); !ok)
        return ok;
    done_ = there;
    if (done_ > 0 || mean == 0)
        return {};
    const auto first = film_.extend(0, 1, {});
    if (!first)
        return first.error();
    done_ = *first;
    return {};
}

Result<void> BatchRender::takeSamples(const double& elapsed, std::stop_token stop, const Extended& told) {
    const OrderSize order = film_.orderSize();
    const std::uint32_t samples = wantedSamples(order, elapsed);
    // An interrupted launch leaves worthless sums, unless the film says otherwise. The first one has nothing to lose.
    const bool leavesFilm = order.whole > 0;
    const bool canBreakOff = leavesFilm || done_ == 0 || whenStopped_ == WhenStopped::discard;
    std::stop_source end;
    const std::stop_callback endWithAll(stop, [&] { end.request_stop(); });
    const auto tellOrEnd = [&](const SampleCounts& counts) {
        told(counts);
        if (leavesFilm && isTimeOver(elapsed))
            end.request_stop();
    };
    const auto there = film_.extend(done_, samples, canBreakOff ? end.get_token() : std::stop_token(), tellOrEnd);
    if (!there)
        return there.error();
    if (canBreakOff && end.stop_requested()) {
        const bool isWorthless = stop.stop_requested() && whenStopped_ == WhenStopped::discard;
        return leavesFilm && !isWorthless ? keepFinished(*there) : Result<void>();
    }
    done_ = *there;
    if (done_ == 0) {
        begunAt_ = elapsed;
        nextLook_ = kSamplesToStop;
        status_ = {};
    }
    return {};
}

/// Reads the film's status, which comes with an image.
Result<void> BatchRender::look() {
    if (done_ == 0)
        return {};
    if (auto ok = film_.resolve(display_); !ok)
        return ok;
    const auto image = film_.readback();
    if (!image)
        return image.error();
    status_ = image->status;
    return {};
}

std::uint32_t BatchRender::wantedSamples(const OrderSize& order, double elapsed) const {
    const bool isWhole = order.whole > 0;
    const std::uint64_t most =
        isWhole ? std::clamp<std::uint64_t>(3 * done_, order.whole, kMostWholeOrder) : order.samples;
    double wanted = double(most);
    if (stops_.seconds || !isWhole)
        wanted = samplesInTime(order, isWhole, elapsed);
    if (stops_.samples)
        wanted = std::min(wanted, double(*stops_.samples - done_));
    if (stopsByError())
        wanted = std::min(wanted, double(nextLook_ - done_));
    return toBlockEnd(std::uint32_t(std::clamp(wanted, 1.0, double(most))));
}

/// Returns the samples for which there is time. An order of a film that is extended tile by tile may take half of the
/// time that is left: the film is even again with the last, short ones.
double BatchRender::samplesInTime(const OrderSize& order, bool isWhole, double elapsed) const {
    if (done_ == 0)
        return 1;
    double seconds = order.seconds;
    if (stops_.seconds) {
        const double left = *stops_.seconds - elapsed;
        seconds = std::min(isWhole ? std::max(seconds, left / 2) : seconds, left);
    }
    return std::floor(seconds * double(done_) / std::max(elapsed - begunAt_, 1e-9));
}

/// Reduces `wanted` so that the samples end with a whole block, if one ends on the way: the rest of a block would be a
/// piece of work, and a message, of its own.
std::uint32_t BatchRender::toBlockEnd(std::uint32_t wanted) const {
    const std::uint64_t end = done_ + wanted, blockEnd = end - end % kSamplesPerBlock;
    const bool isWanted = end == stops_.samples || (stopsByError() && end == nextLook_);
    return isWanted || blockEnd <= done_ ? wanted : std::uint32_t(blockEnd - done_);
}

std::optional<StopReason> BatchRender::reached(double elapsed) const {
    if (stops_.samples && done_ >= *stops_.samples)
        return StopReason::samples;
    if (errorIsDue()) {
        if (stops_.relativeError && isReached(status_.relativeError, *stops_.relativeError, done_))
            return StopReason::error;
        if (stops_.levels && isReached(status_.displayError, *stops_.levels, done_))
            return StopReason::levels;
    }
    if (isTimeOver(elapsed))
        return StopReason::seconds;
    return std::nullopt;
}

bool BatchRender::isTimeOver(double elapsed) const {
    return stops_.seconds && done_ > 0 && elapsed >= *stops_.seconds;
}

BatchState BatchRender::state(double elapsed, const SampleCounts& samples) const {
    BatchState state{status_, elapsed, 0, std::nullopt};
    state.film.meanSamplesPerPixel = samples.mean;
    if (status_.samplesPerPixel == 0)
        state.film.relativeError = std::numeric_limits<double>::infinity();
    if (stops_.samples)
        state.fraction = std::max(state.fraction, samples.mean / double(*stops_.samples));
    if (stops_.seconds)
        state.fraction = std::max(state.fraction, elapsed / *stops_.seconds);
    const auto nearer = [&](const std::optional<double>& target, double error) {
        if (target)
            state.fraction = std::max(state.fraction, double(done_) / samplesToReach(*target, error, done_));
    };
    nearer(stops_.relativeError, status_.relativeError);
    nearer(stops_.levels, status_.displayError);
    state.fraction = std::min(state.fraction, 1.0);
    if (state.fraction > 0)
        state.secondsLeft = elapsed * (1 - state.fraction) / state.fraction;
    return state;
}

}  // namespace pdr
