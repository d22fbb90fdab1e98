#include "app/cli/accuracy/accuracy_curve.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "app/provenance.h"
#include "render/film/image_file.h"
#include "render/film/smoothing_judgement.h"

namespace pdr::app {
namespace {

/// A film that grows, and the time that it took.
class GrowingFilm {
  public:
    static Result<GrowingFilm> of(const Scene& scene, Device& device) {
        if (auto ok = device.upload(scene); !ok)
            return ok.error();
        auto film = device.film(scene.film, scene.revision, scene.schedule);
        if (!film)
            return film.error();
        return GrowingFilm(*std::move(film));
    }

    Result<void> growTo(std::uint64_t samples) {
        const auto start = std::chrono::steady_clock::now();
        Result<void> done = film_->accumulate(std::uint32_t(samples - samples_), {});
        seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        samples_ = samples;
        return done;
    }
    Result<std::shared_ptr<const Film>> film() { return film_->film(); }
    std::uint64_t samples() const { return samples_; }
    double seconds() const { return seconds_; }

  private:
    explicit GrowingFilm(std::unique_ptr<Accumulator> film) : film_(std::move(film)) {}

    std::unique_ptr<Accumulator> film_;
    std::uint64_t samples_ = 0;
    double seconds_ = 0;
};

/// The error at a moment, along a line in logarithms. `seconds` lies within the curve.
double levelsAt(double seconds, const AccuracyCurve& curve) {
    const auto after = std::ranges::find_if(curve.steps, [&](const auto& step) { return step.seconds >= seconds; });
    if (after == curve.steps.begin())
        return after->error.levels;
    const AccuracyStep &a = *(after - 1), &b = *after;
    const double share = std::log(seconds / a.seconds) / std::log(b.seconds / a.seconds);
    return a.error.levels * std::pow(b.error.levels / a.error.levels, share);
}

bool keepsPicture(std::uint64_t samples) {
    return samples == 1 || std::countr_zero(samples) % 2 == 0;  // 1, 4, 16, ...
}

Result<std::filesystem::path> kept(const Film& film, const Display& display, const AccuracyStep& step,
                                   const Scene& scene, const AccuracyPlan& plan) {
    const std::string name =
        std::string(display.smoothed ? "smoothed_" : "raw_") + std::to_string(step.samples) + ".png";
    const Provenance facts =
        provenanceOf(scene, {film.status(display.exposure, [](auto&&...) {}), display.exposure, step.seconds, {}, {}});
    const auto written = writePng(film, display, facts, plan.folder / name);
    if (!written)
        return written.error();
    return std::filesystem::path(name);
}

AccuracyStep rawStep(const Film& film, const Film& reference, double seconds, const Display& display) {
    const FilmStatus status = film.status(display.exposure, [](auto&&...) {});
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference), {}, {}, {}};
    if (std::isfinite(status.displayError))
        step.stated = status.displayError;
    return step;
}

AccuracyStep smoothedStep(const Film& film, const Film& reference, double seconds, const Display& display) {
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference), {}, {}, {}};
    const auto judgement = SmoothingJudgement::of(film);
    if (const auto error = judgement ? judgement->overAll(display.exposure) : std::nullopt)
        step.stated = error->levels, step.atMost = error->levelsAtMost;
    return step;
}

}  // namespace

std::optional<double> secondsToReach(double levels, const AccuracyCurve& curve) {
    auto first = curve.steps.end();
    while (first != curve.steps.begin() && (first - 1)->error.levels <= levels)
        --first;
    if (first == curve.steps.end())
        return std::nullopt;
    if (first == curve.steps.begin() || first->error.levels <= 0)
        return first->seconds;
    const AccuracyStep &a = *(first - 1), &b = *first;
    const double share = std::log(a.error.levels / levels) / std::log(a.error.levels / b.error.levels);
    return a.seconds * std::pow(b.seconds / a.seconds, share);
}

std::optional<double> betterUntil(const AccuracyCurve& biased, const AccuracyCurve& unbiased) {
    if (biased.steps.empty() || unbiased.steps.empty())
        return std::nullopt;
    const double begin = std::max(biased.steps.front().seconds, unbiased.steps.front().seconds);
    const double end = std::min(biased.steps.back().seconds, unbiased.steps.back().seconds);
    constexpr int kMoments = 400;
    std::optional<double> last;
    for (int i = 0; begin < end && i <= kMoments; ++i) {
        const double moment = i == kMoments ? end : begin * std::pow(end / begin, double(i) / kMoments);
        if (levelsAt(moment, biased) <= levelsAt(moment, unbiased))
            last = i == kMoments ? std::numeric_limits<double>::infinity() : moment;
    }
    return last;
}

std::vector<AccuracyWay> accuracyWays(const Scene& scene) {
    std::vector<AccuracyWay> ways{
        {"as it is", scene.estimator == Estimator::kroesMarch ? "march of 3 voxels" : "", scene}};
    const auto add = [&](const char* name, const char* bias, auto change) {
        Scene other = scene;
        change(other);
        if (other.check())
            ways.push_back({name, bias, std::move(other)});
    };
    if (scene.estimator == Estimator::unbiased)
        add("Exposure Render's march", "march of 3 voxels", [](Scene& s) { s.estimator = Estimator::kroesMarch; });
    if (scene.schedule.kind == Schedule::Kind::pd)
        add("Exposure Render's order, blurred", "each iteration is blurred", [](Scene& s) {
            s.schedule.kind = Schedule::Kind::kroes;
            s.schedule.filter = true;
        });
    return ways;
}

Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress) {
    auto film = GrowingFilm::of(way.scene, device);
    if (!film)
        return film.error();
    const bool smooths = way.bias.empty();
    const Display raw{plan.display.exposure, false}, smooth{plan.display.exposure, true};
    std::vector<AccuracyCurve> curves{{way.name, way.bias, {}}};
    if (smooths)
        curves.push_back({way.name + ", smoothed", "fine detail that noise hides", {}});
    for (std::uint64_t samples = 1; samples == 1 || 2 * film->seconds() <= plan.seconds; samples *= 2) {
        progress(std::min(1.0, film->seconds() / plan.seconds), way.name);
        if (auto ok = film->growTo(samples); !ok)
            return ok.error();
        const auto known = film->film();
        if (!known)
            return known.error();
        curves[0].steps.push_back(rawStep(**known, reference, film->seconds(), raw));
        if (smooths)
            curves[1].steps.push_back(smoothedStep(**known, reference, film->seconds(), smooth));
        for (std::size_t i = 0; smooths && keepsPicture(samples) && i < 2; ++i) {
            AccuracyStep& step = curves[i].steps.back();
            const auto file = kept(**known, i == 0 ? raw : smooth, step, way.scene, plan);
            if (!file)
                return file.error();
            step.picture = *file;
        }
        if (stop.stop_requested())
            break;
    }
    return curves;
}

Result<std::shared_ptr<const Film>> referenceFor(const Scene& scene, double seconds, Device& device,
                                                 const std::stop_token& stop, const AccuracyProgress& progress) {
    Scene other = scene;
    other.seed += 1;
    auto film = GrowingFilm::of(other, device);
    if (!film)
        return film.error();
    do {
        const double each = film->samples() == 0 ? 0 : film->seconds() / double(film->samples());
        const double left = each > 0 ? std::clamp((seconds - film->seconds()) / each, 1.0, 16.0) : 2.0;
        if (auto ok = film->growTo(film->samples() + std::uint64_t(left)); !ok)
            return ok.error();
        progress(std::min(1.0, film->seconds() / seconds), "reference");
    } while (film->seconds() < seconds && !stop.stop_requested());
    return film->film();
}

}  // namespace pdr::app
