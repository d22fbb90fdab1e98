#pragma once
/// Measures what an effect costs and what it brings, by rendering a scene with it and the same scene without it in
/// turn. Costs are processor time of the whole program, so that a busy machine changes them little.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/accuracy/cost_band.h"
#include "render/accuracy/image_change.h"
#include "render/device/device.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/prepare/needs.h"
#include "render/scene/scene.h"

namespace pdr {

/// Takes n more iterations of an image and returns the processor time that they took [s]. After a stop request it
/// returns early, and the image is worthless.
using Iterate = std::function<Result<double>(std::uint32_t n, const std::stop_token& stop)>;

/// Measures what one iteration of each image takes [ms], step by step, in kBandMeasurements rounds over all images.
/// This takes at most about `budgetSeconds` in all, but a measurement has at least `fewest` iterations even if these
/// take longer. The first iteration of each image only shows how many fit. The order changes from round to round,
/// so that a drift of the machine's speed cancels.
class CostsInTurn {
  public:
    /// `images` must not be empty.
    CostsInTurn(std::vector<Iterate> images, double budgetSeconds, std::uint32_t fewest = 1);

    bool isDone() const { return rounds_.size() == kBandMeasurements && rounds_.back().size() == images_.size(); }
    /// Takes one measurement of one image. It must not be called when done, nor after a step that was stopped.
    Result<void> step(const std::stop_token& stop = {});
    /// Results, once isDone(): the cost of each image; added(): how much more the first one takes than the second;
    /// share(): that difference as a fraction of the first one's time, at most 1.
    std::vector<CostBand> bands() const;
    CostBand added() const;
    CostBand share() const;

  private:
    Result<void> first(std::size_t image, const std::stop_token& stop);
    /// Returns the band of `value` over all rounds. `value` gets a function from an image's index to its cost in the
    /// round.
    template <class Value>
    CostBand bandOfRounds(const Value& value) const;

    std::vector<Iterate> images_;
    double budgetSeconds_;
    std::uint32_t fewest_;
    std::size_t begun_ = 0;                    ///< images whose first iteration has been taken
    double firstSeconds_ = 0;                  ///< time taken by those iterations
    std::uint32_t iterations_ = 0;             ///< iterations per measurement
    std::vector<std::vector<double>> rounds_;  ///< ms per iteration, for each round in the order of its turns
};

/// Two devices, because one that alternates between scenes prepares each of them anew. In large volumes that takes
/// longer than the samples.
struct DevicePair {
    Device& with;
    Device& without;
};

/// A scene of which an image is rendered for a trial.
class TrialImage {
  public:
    /// Whether other scenes use the device between the first iteration and the last.
    enum class Use { alone, shared };

    /// `device` must outlive this object.
    TrialImage(Scene scene, Device& device, Use use) : scene_(std::move(scene)), device_(device), use_(use) {}

    Result<double> accumulate(std::uint32_t n, const std::stop_token& stop);
    /// Returns the film. At least one iteration must have been taken.
    Result<std::shared_ptr<const Film>> film() const { return film_->film(); }

  private:
    Result<void> begin();

    Scene scene_;
    Device& device_;
    Use use_;
    std::unique_ptr<Accumulator> film_;
};

struct EffectTrial {
    CostBand milliseconds;  ///< cost per iteration, with minus without the effect
    CostBand share;         ///< cost as a fraction of an iteration's time; 1 is all of it
    ImageChange change;     ///< change of the image without the effect
    /// Time to any given error without the effect, relative to the time with it: from what an iteration takes and how
    /// noisy it is. None if an error is not known.
    std::optional<Foretold> time;
};

/// Returns the relative time of an image that needs `samples` times as many samples, each of which takes less time by
/// the fraction `share`.
Foretold timeWithout(const Foretold& samples, const CostBand& share);

/// Display levels that nobody sees, smaller than rounding. An effect could be left out if, to 95 %, it changes 95 % of
/// the image by less than kUnseenLevels and the image on average by less than kUnseenMean.
inline constexpr double kUnseenLevels = 0.5, kUnseenMean = 0.05;
bool isUnseen(const ImageChange& change);

/// Tries an effect of `scene` that can be left out, step by step. Errors: the device's.
class EffectTrying {
  public:
    /// `devices` must outlive this object, which has sole use of them.
    EffectTrying(const Effect& effect, const Scene& scene, const DevicePair& devices, double budgetSeconds);
    /// Tries whatever differs between two scenes of the same film size.
    EffectTrying(const Scene& with, const Scene& without, const DevicePair& devices, double budgetSeconds);

    bool isDone() const { return costs_.isDone(); }
    /// Runs one launch of one of the two images. It must not be called when done, nor after a step that was stopped.
    Result<void> step(const std::stop_token& stop) { return costs_.step(stop); }
    /// Returns the result; isDone() must be true.
    Result<EffectTrial> trial(const Display& display) const;

  private:
    TrialImage with_, without_;
    CostsInTurn costs_;
};

/// Returns the film size of a small image for trials of `scene`: at most `longestSide` pixels, and so few (at least 16
/// on its longest side) that an iteration takes about `seconds` of processor time. Worthless after a stop request.
Result<ivec2> trialFilm(const Scene& scene, Device& device, int longestSide, double seconds,
                        const std::stop_token& stop = {});

}  // namespace pdr
