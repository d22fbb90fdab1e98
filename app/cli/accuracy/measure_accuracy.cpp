#include "app/cli/accuracy/measure_accuracy.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/provenance.h"
#include "render/film/image_file.h"
#include "render/film/smoothing_judgement.h"
#include "render/session/bias_lattice.h"

namespace pdr::app {
namespace {

/// Of a way's time, for what measures its bias.
constexpr double kBiasShare = 0.1;

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
    Result<void> goOnFrom(const KeptFilm& before) {
        samples_ = before.film->samplesPerPixel();
        seconds_ = before.seconds;
        return film_->resume(*before.film);
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

bool keepsPicture(std::uint64_t samples) {
    return samples == 1 || std::countr_zero(samples) % 2 == 0;  // 1, 4, 16, ...
}

Result<std::filesystem::path> kept(const Film& film, const Display& display, const AccuracyStep& step,
                                   const Scene& scene, const AccuracyPlan& plan) {
    const std::string name =
        std::string(display.smoothed ? "smoothed_" : "raw_") + std::to_string(step.samples) + ".png";
    const Provenance facts =
        provenanceOf(scene, {film.status(display.exposure), display.exposure, step.seconds, plan.device, {}});
    const auto written = writePng(film, display, facts, plan.folder / name);
    if (!written)
        return written.error();
    return std::filesystem::path(name);
}

AccuracyStep rawStep(const Film& film, const Film& reference, double seconds, const Display& display) {
    const FilmStatus status = film.status(display.exposure);
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference)};
    if (std::isfinite(status.displayError))
        step.stated = status.displayError;
    return step;
}

AccuracyStep smoothedStep(const Film& film, const Film& reference, double seconds, const Display& display) {
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference)};
    const auto judgement = SmoothingJudgement::of(film);
    if (const auto error = judgement ? judgement->overAll(display.exposure) : std::nullopt)
        step.stated = error->levels, step.atMost = error->levelsAtMost;
    return step;
}

/// What was foretold of the newest step by the picture that had 1 / 2^halvings of its samples.
std::optional<Foretold> foretold(const std::vector<ErrorHistory>& histories, std::size_t halvings,
                                 const AccuracyStep& newest) {
    if (!newest.stated || *newest.stated <= 0 || histories.size() <= halvings)
        return std::nullopt;
    const ErrorHistory& then = histories[histories.size() - 1 - halvings];
    return then.steps().empty() ? std::nullopt : std::optional(then.seconds(*newest.stated));
}

/// The curves of a way while it is rendered.
class Measurement {
  public:
    Measurement(const AccuracyWay& way, const Film& reference, const AccuracyPlan& plan)
        : way_(way), reference_(reference), plan_(plan) {
        curves_.push_back({way.name, way.bias});
        if (way.bias.empty() && canBeSmoothed(way.scene))
            curves_.push_back({way.name + ", smoothed", "fine detail that noise hides"});
    }

    /// Errors: of files.
    Result<void> add(const Film& film, double seconds) {
        const Display raw{plan_.display.exposure, false}, smooth{plan_.display.exposure, true};
        AccuracyStep step = rawStep(film, reference_, seconds, raw);
        ErrorHistory history = histories_.empty() ? ErrorHistory() : histories_.back();
        history.add(seconds, film.status(raw.exposure));
        histories_.push_back(std::move(history));
        step.foretoldAtQuarter = foretold(histories_, 2, step);
        step.foretoldAtSixteenth = foretold(histories_, 4, step);
        curves_[0].steps.push_back(std::move(step));
        if (curves_.size() > 1)
            curves_[1].steps.push_back(smoothedStep(film, reference_, seconds, smooth));
        return keep(film, raw, smooth);
    }
    std::vector<AccuracyCurve> curves() && { return std::move(curves_); }

  private:
    Result<void> keep(const Film& film, const Display& raw, const Display& smooth) {
        if (plan_.folder.empty() || curves_.size() < 2 || !keepsPicture(film.samplesPerPixel()))
            return {};
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            AccuracyStep& step = curves_[i].steps.back();
            const auto file = kept(film, i == 0 ? raw : smooth, step, way_.scene, plan_);
            if (!file)
                return file.error();
            step.picture = *file;
        }
        return {};
    }

    const AccuracyWay& way_;
    const Film& reference_;
    const AccuracyPlan& plan_;
    std::vector<AccuracyCurve> curves_;
    std::vector<ErrorHistory> histories_;  ///< after each step
};

}  // namespace

Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress) {
    auto film = GrowingFilm::of(way.scene, device);
    if (!film)
        return film.error();
    Measurement measurement(way, reference, plan);
    const double seconds = way.bias.empty() ? plan.seconds : (1 - kBiasShare) * plan.seconds;
    for (std::uint64_t samples = 1; samples == 1 || 2 * film->seconds() <= seconds; samples *= 2) {
        progress(std::min(1.0, film->seconds() / plan.seconds), way.name);
        if (auto ok = film->growTo(samples); !ok)
            return ok.error();
        const auto known = film->film();
        if (!known)
            return known.error();
        if (auto ok = measurement.add(**known, film->seconds()); !ok)
            return ok.error();
        if (stop.stop_requested())
            break;
    }
    std::vector<AccuracyCurve> curves = std::move(measurement).curves();
    if (!way.bias.empty()) {
        const auto bias = measureBias(way.scene, plan.display.exposure, device, kBiasShare * plan.seconds, stop);
        if (!bias)
            return bias.error();
        curves[0].measuredBias = *bias;
    }
    return curves;
}

Scene referenceScene(Scene scene) {
    Scene other = exactly(std::move(scene));
    other.seed += 1;
    return other;
}

Result<KeptFilm> referenceFor(const Scene& scene, double seconds, const std::optional<KeptFilm>& before, Device& device,
                              const std::stop_token& stop, const AccuracyProgress& progress) {
    auto film = GrowingFilm::of(scene, device);
    if (!film)
        return film.error();
    if (before)
        if (auto ok = film->goOnFrom(*before); !ok)
            return ok.error();
    while (film->samples() == 0 || (film->seconds() < seconds && !stop.stop_requested())) {
        const double each = film->samples() == 0 ? 0 : film->seconds() / double(film->samples());
        const double left = each > 0 ? std::clamp((seconds - film->seconds()) / each, 1.0, 16.0) : 2.0;
        if (auto ok = film->growTo(film->samples() + std::uint64_t(left)); !ok)
            return ok.error();
        progress(std::min(1.0, film->seconds() / seconds), "reference");
    }
    const auto known = film->film();
    if (!known)
        return known.error();
    return KeptFilm{*known, film->seconds()};
}

}  // namespace pdr::app
