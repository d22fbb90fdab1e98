#pragma once
/// What a biased way to make pictures is off, measured beside them: a sparse lattice of small tiles of the same view,
/// made that way and exactly.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "render/accuracy/bias_estimate.h"
#include "render/base/result.h"
#include "render/base/tile.h"
#include "render/scene/scene.h"

namespace pdr {

class Device;

/// The same picture without what is known to make it another one: unbiased, filtered exactly, nothing blurred.
Scene exactly(Scene scene);

/// Two ways to one picture, and how they are compared.
struct TwoWays {
    /// Of either: of random numbers of their own, or of the same, so that nearly all that differs is the bias; or as an
    /// average that leaves the first sample out, and forgets that it did.
    enum class Samples { independent, same, sameButTheFirst };

    Scene biased, exact;
    Samples compared = Samples::independent;
    /// Of every pixel in a round, either way. Of fewer than 64 independent ones the curve of the display makes a bias
    /// of the noise.
    std::uint32_t samples = 64;
};

/// March, blur and fast filter, all that `scene` has of them, and the picture without.
TwoWays withoutShortcuts(const Scene& scene);
/// The running mean of Exposure Render's order of work, and the same samples, which are also those of the mean, summed
/// in double. Each round is of twice the samples of the one before and takes its place: rounding errors grow with them.
TwoWays withoutRounding(const Scene& scene);
/// A projection, and the same rays to a hundredth of its tolerance.
TwoWays withoutTolerance(const Scene& scene);

class BiasLattice {
  public:
    /// `ways.biased` must have passed Scene::check().
    explicit BiasLattice(TwoWays ways);

    /// A round, with random numbers that no other round has. `device` holds another scene then. A round that is
    /// stopped, or fails with the device's error, counts for nothing.
    Result<void> addRound(Device& device, const std::stop_token& stop);

    /// On a display of that exposure; nothing while too little is known.
    std::optional<MeasuredBias> measured(double exposure) const;
    /// Of each pixel, that are known.
    std::uint64_t samples() const { return samples_; }

  private:
    struct Pixel {
        BothWays sums;  ///< over the rounds that count
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
