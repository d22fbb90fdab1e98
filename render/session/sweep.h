#pragma once
/// Chooses which part of a film gets samples next. A pass gives every pixel of a part n more samples, in pieces.
/// Pixels of the part that lag behind go first, so that an area that ran ahead waits for the rest.

#include <cstdint>
#include <utility>

#include "render/film/tile_progress.h"

namespace pdr {

class Sweep {
  public:
    /// A request for n more samples for each pixel of a tile.
    struct Order {
        Tile tile;
        std::uint32_t n = 0;
    };

    Sweep() = default;
    /// Starts with a film of that progress; the part is its whole area.
    explicit Sweep(TileProgress progress) : progress_(std::move(progress)), part_(progress_.area()) {}

    /// The whole film, and the part of it that is being sampled.
    const Tile& area() const { return progress_.area(); }
    const Tile& part() const { return part_; }
    bool isWhole() const { return part_ == area(); }
    SampleCounts samples() const { return progress_.counts(); }
    /// Returns the samples that every pixel of `part` has; `part` consists of whole cells of the film.
    std::uint64_t samplesOf(const Tile& part) const { return progress_.counts(part).least; }
    std::uint64_t partSamples() const { return samplesOf(part_); }

    /// Chooses the cells around `part` for the next passes. No pass may be incomplete.
    void choose(const Tile& part) {
        part_ = progress_.cellsAround(part);
        goal_ = 0;  // else what lags behind another part would continue its pass, without an image until it ends
    }
    /// Begins a pass: at most n samples, n >= 1, for the pixels that lag behind in the part.
    void begin(std::uint32_t n);
    /// Returns whether a pass has begun and not ended.
    bool isHalfMade() const { return samplesOf(part_) < goal_; }
    /// Samples that each pixel gets in the pass.
    std::uint32_t passSamples() const { return n_; }
    /// Returns the next piece of the incomplete pass: about `pixels` pixels of a tile, in whole rows of cells.
    Order next(double pixels) const;
    /// Records that `order` was carried out. Returns the samples that every pixel of the part got if that ends the
    /// pass; 0 if it does not.
    std::uint32_t took(const Order& order);

  private:
    TileProgress progress_;
    Tile part_;
    std::uint64_t goal_ = 0;  ///< samples of each pixel of the part at the end of the pass
    std::uint32_t n_ = 0;
};

}  // namespace pdr
