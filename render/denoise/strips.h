#pragma once
/// Sums along straight lines: over strips of pixels, 45 long and 2 wide, in 24 directions, wherever they fit into an
/// image. The strips of one direction have one shape, so that the sums of neighbours share all but their ends.
///   u, v    pixels along the axis that the direction is nearer to, and along the other one; v where u is 0

#include "render/denoise/plane.h"

namespace pdr::denoise {

inline constexpr int kDirections = 24;
inline constexpr double kStripLength = 45, kStripWidth = 2;

/// One of kDirections directions: half a turn in even steps, from x to y.
struct Direction {
    bool steep = false;  ///< u is y
    double slope = 0;    ///< slope of v over u, [-1, 1]
    double stretch = 1;  ///< length of the step from one u to the next [pixels]
    int length = 0;      ///< steps of u
    int width = 0;       ///< pixels of v

    explicit Direction(int index);

    /// Returns the first pixel across at `u` of the strip that has `v` where u is 0.
    int across(int u, int v) const;
};

struct Strip {
    int direction = 0, u = 0, v = 0;
    float z = 0;  ///< sum over the standard deviation of its noise
};

/// Returns the strips whose sum of `values` is beyond `leastZ` > 0 standard deviations of its noise, positive or
/// negative, in a fixed order. `variance`: of each value, independent of the others'. A strip without noise is left
/// out. Incomplete after a stop request.
std::vector<Strip> strongStrips(const Plane& values, const Plane& variance, double leastZ, const std::stop_token& stop);

}  // namespace pdr::denoise
