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

class BiasLattice {
  public:
    /// Samples of every pixel in a round, either way: of fewer the curve of the display makes a bias of the noise.
    static constexpr std::uint32_t kRound = 64;

    /// `biased` must have passed Scene::check().
    explicit BiasLattice(Scene biased);

    /// A round, with random numbers that no other round has. `device` holds another scene then. A round that is
    /// stopped, or fails with the device's error, counts for nothing.
    Result<void> addRound(Device& device, const std::stop_token& stop);

    /// On a display of that exposure; nothing while too little is known.
    std::optional<MeasuredBias> measured(double exposure) const;
    std::uint64_t samples() const { return kRound * rounds_; }

  private:
    struct Pixel {
        BothWays sums;  ///< over the rounds
        bool tissue = false;
    };
    struct Tiled {
        Tile tile;
        std::vector<Pixel> pixels;  ///< row by row
    };

    Result<void> add(const Scene& scene, HalfMeans BothWays::*way, Device& device, const std::stop_token& stop,
                     std::vector<Tiled>& tiles) const;

    Scene biased_;
    std::vector<Tiled> tiles_;
    std::uint64_t rounds_ = 0;
};

/// Of `biased`, in as many rounds as fit `seconds`, and one at least. Nothing where that is too little, or after a stop
/// request. Errors: the device's.
Result<std::optional<MeasuredBias>> measureBias(const Scene& biased, double exposure, Device& device, double seconds,
                                                const std::stop_token& stop);

}  // namespace pdr
