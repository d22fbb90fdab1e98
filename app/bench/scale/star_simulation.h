#pragma once
/// Event simulation of a star of nodes (render/timing/scaling.h), for what the formulas average out: nodes that wait,
/// and results that queue up. Sort-last and sums that are added up on the way are not stars.

#include <cstdint>
#include <optional>
#include <vector>

#include "render/timing/scaling.h"

namespace pdr::bench::scale {

/// Pieces of work for nodes that get a new one for each result.
struct StarWork {
    std::vector<double> pieces;  ///< seconds of each, in the order in which they are handed out
    std::int64_t nodes = 1;
    double setup = 0;  ///< seconds of every node before its first piece
    Link link;
    double resultBytes = 0;  ///< bytes of the result of a piece
};

struct StarTimes {
    double computed = 0;  ///< seconds from the arrival of the first request to the end of the last piece
    double latency = 0;   ///< seconds from the first request until the last result is taken in
    double link = 0;      ///< seconds for which the link was busy
};

StarTimes play(const StarWork& work);

/// Returns frame rate, latency, efficiency, bytes and messages of simulated frames. The costs of tiles are drawn from
/// the histogram; the figures are means over as many frames as make their random error small. Null for a way that is
/// not a star.
std::optional<ScaledFrames> simulated(const ScalingFacts& facts, Distribution how, std::int64_t nodes,
                                      std::uint32_t seed = 1);

}  // namespace pdr::bench::scale
