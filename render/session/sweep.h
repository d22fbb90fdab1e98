#pragma once
/// Which part of a film gets samples next. A pass gives every pixel of a part n more samples, in pieces; what lags
/// within that part goes first, so that a part that ran ahead waits for the rest.

#include <cstdint>
#include <utility>

#include "render/film/tile_progress.h"

namespace pdr {

class Sweep {
  public:
    /// n more samples for each pixel of a tile.
    struct Order {
        Tile tile;
        std::uint32_t n = 0;
    };

    Sweep() = default;
    /// Of a film that is so far.
    explicit Sweep(TileProgress progress) : progress_(std::move(progress)), part_(progress_.area()) {}

    /// That is being sampled.
    const Tile& part() const { return part_; }
    SampleCounts samples() const { return progress_.counts(); }
    /// That every pixel of `part`, whole cells of the film, has.
    std::uint64_t samplesOf(const Tile& part) const { return progress_.counts(part).least; }

    /// The next passes go over the cells around `part`. None may be half made.
    void choose(const Tile& part) { part_ = progress_.cellsAround(part); }
    /// Begins a pass: at most n samples for the pixels that lag behind in the part, n >= 1.
    void begin(std::uint32_t n);
    /// Whether a pass has begun that has not ended.
    bool isHalfMade() const { return samplesOf(part_) < goal_; }
    /// The next piece of the pass, which is half made: all of a tile or, where n is 1, about so many `pixels` of it.
    Order next(double pixels) const;
    /// That order was carried out. The samples that every pixel of the part has got when that ends the pass; 0: it has
    /// not ended.
    std::uint32_t took(const Order& order);

  private:
    TileProgress progress_;
    Tile part_;
    std::uint64_t goal_ = 0;  ///< samples of each pixel of the part when the pass ends
    std::uint32_t n_ = 0;
};

}  // namespace pdr
