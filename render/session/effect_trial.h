#pragma once
/// What an effect costs and what it brings: a scene with it and the same scene without it, rendered in turn. Costs are
/// processor time of the whole program, so that a busy machine changes them little.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/accuracy/cost_band.h"
#include "render/accuracy/picture_change.h"
#include "render/device/device.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/prepare/needs.h"
#include "render/scene/scene.h"

namespace pdr {

/// Takes n more iterations of a picture; the result is the processor time that they took [s]. After a stop request it
/// returns early, and the picture is worthless.
using Iterate = std::function<Result<double>(std::uint32_t n, const std::stop_token& stop)>;

/// What one iteration of each picture takes [ms], measured in turn, kBandMeasurements times, in at most about
/// `budgetSeconds` in all, step by step, but `fewest` iterations at a time where even these take longer. The first
/// iteration of each only shows how many fit. The order changes from round to round, so that a drift of the machine's
/// speed cancels.
class CostsInTurn {
  public:
    /// `pictures`: at least one.
    CostsInTurn(std::vector<Iterate> pictures, double budgetSeconds, std::uint32_t fewest = 1);

    bool isDone() const { return rounds_.size() == kBandMeasurements && rounds_.back().size() == pictures_.size(); }
    /// One measurement of one picture; not when it is done, nor after one that was stopped.
    Result<void> step(const std::stop_token& stop = {});
    /// When it is done: of each picture; of what the first takes more than the second; and the part of the first's time
    /// that this is, 1 at most.
    std::vector<CostBand> bands() const;
    CostBand added() const;
    CostBand share() const;

  private:
    Result<void> first(std::size_t picture, const std::stop_token& stop);
    /// Of picture(round).
    template <class Value>
    CostBand bandOfRounds(const Value& value) const;

    std::vector<Iterate> pictures_;
    double budgetSeconds_;
    std::uint32_t fewest_;
    std::size_t begun_ = 0;                    ///< pictures whose first iteration is taken
    double firstSeconds_ = 0;                  ///< that they took
    std::uint32_t iterations_ = 0;             ///< of each measurement
    std::vector<std::vector<double>> rounds_;  ///< ms an iteration, of each round in the order of its turns
};

/// Two devices, since one that goes from scene to scene prepares each of them anew: in large volumes that takes longer
/// than the samples.
struct DevicePair {
    Device& with;
    Device& without;
};

/// A scene on its way to a picture.
class TrialPicture {
  public:
    /// Whose the device is, from the first iteration to the last.
    enum class Use { alone, shared };

    /// `device` must outlive it.
    TrialPicture(Scene scene, Device& device, Use use) : scene_(std::move(scene)), device_(device), use_(use) {}

    Result<double> accumulate(std::uint32_t n, const std::stop_token& stop);
    /// At least one iteration must have been taken.
    Result<std::shared_ptr<const Film>> film() const { return film_->film(); }

  private:
    Result<void> begin();

    Scene scene_;
    Device& device_;
    Use use_;
    std::unique_ptr<Accumulator> film_;
};

struct EffectTrial {
    CostBand milliseconds;         ///< per iteration: with minus without
    CostBand share;                ///< of an iteration's time: 1 is all of it
    PictureChange change;          ///< without it
    std::optional<Foretold> time;  ///< so many times as long to any target without it: what an iteration takes and how
                                   ///< noisy it is, both; none where an error is not known
};

/// `samples` times as many of them, each for the share less: so many times as long.
Foretold timeWithout(const Foretold& samples, const CostBand& share);

/// Levels that nobody sees: less than what is rounded away. An effect that changes 95 % of the picture by less than
/// kUnseenLevels and the picture as a whole by less than kUnseenMean, to 95 %, could be left out.
inline constexpr double kUnseenLevels = 0.5, kUnseenMean = 0.05;
bool isUnseen(const PictureChange& change);

/// Trying an effect of `scene` that can be left out, step by step. Errors: those of the device.
class EffectTrying {
  public:
    /// `devices` must outlive it, and are its own meanwhile.
    EffectTrying(const Effect& effect, const Scene& scene, const DevicePair& devices, double budgetSeconds);
    /// The same of whatever parts two scenes of one film.
    EffectTrying(const Scene& with, const Scene& without, const DevicePair& devices, double budgetSeconds);

    bool isDone() const { return costs_.isDone(); }
    /// One launch of one of the two pictures; not when it is done, nor after one that was stopped.
    Result<void> step(const std::stop_token& stop) { return costs_.step(stop); }
    /// When it is done.
    Result<EffectTrial> trial(const Display& display) const;

  private:
    TrialPicture with_, without_;
    CostsInTurn costs_;
};

/// The film of a small picture for trials of `scene`: at most `longestSide` pixels, and so few (at least 16 on its
/// longest side) that an iteration takes about `seconds` of processor time. Worthless after a stop request.
Result<ivec2> trialFilm(const Scene& scene, Device& device, int longestSide, double seconds,
                        const std::stop_token& stop = {});

}  // namespace pdr
