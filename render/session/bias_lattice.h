#pragma once
/// Measures the bias of a way of rendering beside the image: a sparse lattice of small tiles of the same view is
/// rendered in that way and exactly.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "render/accuracy/bias_estimate.h"
#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/scene/scene.h"

namespace pdr {

class Device;

/// Returns the same scene without everything known to bias its image: unbiased estimator, exact filtering, no blur.
Scene exactly(Scene scene);

/// Two ways to render one image, and how they are compared.
struct TwoWays {
    /// Relation of the samples of both ways. independent: different random numbers. same: the same random numbers,
    /// so that nearly all that differs is the bias. sameButTheFirst: the same, where the biased way is an average that
    /// silently loses the first sample.
    enum class Samples { independent, same, sameButTheFirst };

    Scene biased, exact;
    Samples compared = Samples::independent;
    /// Samples per pixel in a round, for either way. With fewer than 64 independent ones, the tone curve of the display
    /// turns noise into bias.
    std::uint32_t samples = 64;
};

/// Compares `scene` with march, blur and fast filter, as far as it uses them, to the same scene without them.
TwoWays withoutShortcuts(const Scene& scene);
/// Compares the running mean of Exposure Render's schedule to a sum in double precision of the same samples, those that
/// the mean contains. Each round has twice the samples of the one before and replaces it, because rounding errors grow
/// with the samples.
TwoWays withoutRounding(const Scene& scene);
/// Compares a projection to the same rays integrated to a hundredth of its tolerance.
TwoWays withoutTolerance(const Scene& scene);

class BiasLattice {
  public:
    /// `ways.biased` must have passed Scene::check().
    explicit BiasLattice(TwoWays ways);

    /// Renders one round, with random numbers that no other round has. Afterwards `device` holds another scene. A
    /// round that is stopped, or fails with the device's error, does not count.
    Result<void> addRound(Device& device, const std::stop_token& stop);

    /// Returns the bias on a display of that tone; nothing while too little is known.
    std::optional<MeasuredBias> measured(const Tone& tone) const;
    /// Returns the samples of each pixel that count so far.
    std::uint64_t samples() const { return samples_; }

  private:
    struct Pixel {
        BothWays sums;  ///< sums over the rounds that count
        bool tissue = false;
    };
    struct Tiled {
        Tile tile;
        std::vector<Pixel> pixels;  ///< row by row
    };

    bool grows() const { return ways_.compared == TwoWays::Samples::sameButTheFirst; }
    std::uint32_t nextRound() const { return grows() ? std::uint32_t(ways_.samples << rounds_) : ways_.samples; }
    Result<void> add(const Scene& scene, HalfMeans BothWays::*way, Device& device, const std::stop_token& stop,
                     std::vector<Tiled>& tiles) const;

    TwoWays ways_;
    std::vector<Tiled> empty_, tiles_;
    std::uint64_t rounds_ = 0, samples_ = 0;
};

}  // namespace pdr
