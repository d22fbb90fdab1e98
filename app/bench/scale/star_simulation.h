#pragma once
/// A star of nodes (render/timing/scaling.h) played event by event, for what the formulas leave to averages: nodes that
/// wait, results that queue up. Sort-last and sums that are added up on the way are no star.

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
    double resultBytes = 0;  ///< of a piece
};

struct StarTimes {
    double computed = 0;  ///< from the arrival of the first order to the end of the last piece
    double latency = 0;   ///< from the first order to the last result, taken in
    double link = 0;      ///< that the link was busy
};

StarTimes play(const StarWork& work);

/// Frame rate, latency, efficiency, bytes and messages of frames whose tiles have costs that are drawn from the
/// histogram; the mean of as many frames as make the chance in it small. Nothing for what is no star.
std::optional<ScaledFrames> simulated(const ScalingFacts& facts, Distribution how, std::int64_t nodes,
                                      std::uint32_t seed = 1);

}  // namespace pdr::bench::scale
