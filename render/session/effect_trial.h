#pragma once
/// What an effect costs and what it brings: a scene with it and the same scene without it, rendered in turn. Costs are
/// processor time of the whole program, so that a busy machine changes them little.

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "render/accuracy/cost_band.h"
#include "render/device/device.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/prepare/needs.h"
#include "render/scene/scene.h"

namespace pdr {

/// Takes n more iterations of a picture; the result is the processor time that they took [s].
using Iterate = std::function<Result<double>(std::uint32_t n)>;

/// What one iteration of each picture takes [ms], measured in turn, kBandMeasurements times, in at most about
/// `budgetSeconds` in all; a picture of which one iteration takes longer than its share gets one at a time. The first
/// iteration of each only shows how many fit.
Result<std::vector<CostBand>> costsInTurn(const std::vector<Iterate>& pictures, double budgetSeconds);

/// The band of what one iteration with takes more than one without [ms]; measured like that, the order of the two
/// changing from pair to pair so that a drift of the machine's speed cancels.
Result<CostBand> addedCost(const Iterate& with, const Iterate& without, double budgetSeconds);

/// A scene on its way to a picture.
class TrialPicture {
  public:
    /// `device` must outlive it.
    TrialPicture(Scene scene, Device& device) : scene_(std::move(scene)), device_(device) {}

    Result<double> accumulate(std::uint32_t n);
    /// At least one iteration must have been taken.
    Result<std::shared_ptr<const Film>> film() const { return film_->film(); }

  private:
    Result<void> begin();

    Scene scene_;
    Device& device_;
    std::unique_ptr<Accumulator> film_;
};

struct EffectTrial {
    CostBand milliseconds;  ///< per iteration: with minus without
    double levels = 0;  ///< display levels of 255 by which the picture changes without it: mean over pixels and colours
};

/// Below, a change is 0.00 levels: nobody could tell.
inline constexpr double kNoLevels = 0.005;

/// Of an effect of `scene` that can be left out. Errors: those of the device.
Result<EffectTrial> tryEffect(const Effect& effect, const Scene& scene, const Display& display, Device& device,
                              double budgetSeconds);

/// The film of a small picture for trials of `scene`: at most `longestSide` pixels, and so few (at least 16 on its
/// longest side) that an iteration takes about `seconds` of processor time.
Result<ivec2> trialFilm(const Scene& scene, Device& device, int longestSide, double seconds);

}  // namespace pdr
