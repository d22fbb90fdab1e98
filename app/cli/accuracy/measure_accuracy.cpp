#include "app/cli/accuracy/measure_accuracy.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/output/provenance.h"
#include "render/film/display/denoised_view.h"
#include "render/film/file/image_file.h"
#include "render/session/bias_lattice.h"
#include "render/session/bias_measurements.h"

namespace pdr::app {
namespace {

/// A film that accumulates samples, and its rendering time.
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

bool keepsImage(std::uint64_t samples) {
    return samples == 1 || std::countr_zero(samples) % 2 == 0;  // 1, 4, 16, ...
}

AccuracyStep rawStep(const Film& film, const FilmStatus& status, const Film& reference, double seconds,
                     const Display& display) {
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference)};
    if (std::isfinite(status.displayError))
        step.stated = status.displayError;
    return step;
}

/// Returns the step of a denoised image. `view` has judged the film.
AccuracyStep denoisedStep(const Film& film, DenoisedView& view, const Film& reference, double seconds,
                          const Display& display) {
    AccuracyStep step{film.samplesPerPixel(), seconds, trueError(film, display, reference)};
    if (const auto error = view.error(display))
        step.stated = error->levels, step.atMost = error->levelsAtMost;
    return step;
}

/// Returns the time that was predicted for the newest step when the image had 1 / 2^halvings of its samples; null if
/// there was no prediction.
std::optional<Foretold> foretold(const std::vector<ErrorHistory>& histories, std::size_t halvings,
                                 const AccuracyStep& newest) {
    if (!newest.stated || *newest.stated <= 0 || histories.size() <= halvings)
        return std::nullopt;
    const ErrorHistory& then = histories[histories.size() - 1 - halvings];
    return then.steps().empty() ? std::nullopt : std::optional(then.seconds(*newest.stated));
}

/// Builds the curves of a way while it is rendered.
class Measurement {
  public:
    Measurement(const AccuracyWay& way, const Film& reference, const AccuracyPlan& plan)
        : way_(way),
          reference_(reference),
          plan_(plan),
          raw_(plan.display.withDenoised(false)),
          smooth_(plan.display.withDenoised(true)) {
        curves_.push_back({.name = way.name, .bias = way.bias});
        if (way.bias.empty() && canBeDenoised(way.scene))
            curves_.push_back({.name = way.name + ", denoised", .missing = "fine detail that noise hides"});
    }

    /// Adds a step to each curve. Errors: those of files.
    Result<void> add(const Film& film, double seconds) {
        const FilmStatus status = film.status(raw_);
        addRaw(film, status, seconds);
        DenoisedView view;
        if (curves_.size() > 1) {
            view.judge(film, film.samplesPerPixel(), {});
            curves_[1].steps.push_back(denoisedStep(film, view, reference_, seconds, smooth_));
        }
        if (plan_.folder.empty() || curves_.size() < 2 || !keepsImage(film.samplesPerPixel()))
            return {};
        const Provenance facts = provenanceOf(way_.scene, {status, raw_, seconds, plan_.device, {}});
        if (auto ok = keep("raw_", film, raw_, facts, view, curves_[0].steps.back()); !ok)
            return ok;
        return keep("denoised_", film, smooth_, facts, view, curves_[1].steps.back());
    }
    std::vector<AccuracyCurve> curves() && { return std::move(curves_); }

  private:
    void addRaw(const Film& film, const FilmStatus& status, double seconds) {
        AccuracyStep step = rawStep(film, status, reference_, seconds, raw_);
        ErrorHistory history = histories_.empty() ? ErrorHistory() : histories_.back();
        history.add(seconds, status);
        histories_.push_back(std::move(history));
        step.foretoldAtQuarter = foretold(histories_, 2, step);
        step.foretoldAtSixteenth = foretold(histories_, 4, step);
        curves_[0].steps.push_back(std::move(step));
    }
    Result<void> keep(const char* prefix, const Film& film, const Display& display, const Provenance& facts,
                      DenoisedView& view, AccuracyStep& step) const {
        const std::string name = prefix + std::to_string(step.samples) + ".png";
        if (auto written = writePng(film, display, view, facts, plan_.folder / name); !written)
            return written;
        step.image = name;
        return {};
    }

    const AccuracyWay& way_;
    const Film& reference_;
    const AccuracyPlan& plan_;
    Display raw_, smooth_;
    std::vector<AccuracyCurve> curves_;
    std::vector<ErrorHistory> histories_;  ///< error history after each step
};

}  // namespace

Result<std::vector<AccuracyCurve>> measureAccuracy(const AccuracyWay& way, const Film& reference,
                                                   const AccuracyPlan& plan, Device& device,
                                                   const std::stop_token& stop, const AccuracyProgress& progress) {
    auto film = GrowingFilm::of(way.scene, device);
    if (!film)
        return film.error();
    Measurement measurement(way, reference, plan);
    const double seconds = way.bias.empty() ? plan.seconds : (1 - kBiasTimeShare) * plan.seconds;
    // Double the samples until the next step would exceed the time
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
    // Measure the bias in the time that is left for it
    std::vector<AccuracyCurve> curves = std::move(measurement).curves();
    if (!way.bias.empty()) {
        const auto bias = measureBias(way.scene, plan.display, device, kBiasTimeShare * plan.seconds, stop);
        if (!bias)
            return bias.error();
        curves[0].measuredBias = bias->shortcuts;
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
