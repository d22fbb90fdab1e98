#pragma once
/// HU along a line through an edge, and where they are halfway between its sides.

#include <optional>
#include <vector>

#include "render/measure/weighted_voxels.h"

namespace pdr::measure {

/// A line through a place; distances along it are signed and in mm.
struct ThroughEdge {
    dvec3 mm;
    dvec3 direction;  ///< unit vector, towards the higher HU
};

/// A part of a line [mm].
struct Stretch {
    double from, to;
};

/// Where a profile crosses the half level, and the plateaus that make the level.
struct Crossing {
    double atMm;
    double lowHu, highHu;
    Stretch low, high;       ///< where the levels were taken; low.from and low.to < atMm
    double slopeHuPerMm;     ///< at the crossing; > 0
    bool lowFree, highFree;  ///< no other edge is near enough to shorten the plateau
    double roomMm;           ///< distance to the next edge on either side; infinite: none
};

class EdgeProfile {
  public:
    /// Samples the line, each value the mean over a disc of 1 mm radius.
    EdgeProfile(const Volume& volume, const GridPlace& grid, const ThroughEdge& line);

    /// Returns the crossing at the steepest rise within `reachMm` of the middle, if there is one.
    std::optional<Crossing> crossing(double reachMm) const;
    /// Returns the variance by which noise moves the half level against the profile at a crossing [HU^2].
    double variance(const Crossing& crossing, const Noise& noise) const;

  private:
    double at(double mm) const;
    double level(Stretch stretch, bool free) const;
    double extreme(double from, int way) const;
    std::optional<double> rising(double from, double level) const;
    double nextEdge(double edge, int way, double level) const;
    void add(WeightedVoxels& voxels, double mm, double weight) const;

    const GridPlace& grid_;
    ThroughEdge line_;
    std::vector<dvec3> disc_;  ///< offsets across the line [mm]
    std::vector<double> hu_;   ///< from -kHalfMm to kHalfMm
};

}  // namespace pdr::measure
