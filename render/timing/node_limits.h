#pragma once
/// What ends the gain of more render nodes, cause by cause, and what all of them wait for first: the scan. scaled()
/// (scaling.h) has the frames of any number of nodes.

#include <vector>

#include "render/timing/scaling.h"

namespace pdr {

enum class NodeLimit {
    results,   ///< pixels from the nodes fill the coordinator's link
    orders,    ///< requests to the nodes fill it the other way
    messages,  ///< the coordinator does nothing but take in results
    tiles,     ///< no tile is left for another node
};

struct LimitedNodes {
    NodeLimit limit;
    double nodes;  ///< number of nodes at which this limit alone is reached; infinite: never
};

/// Returns all limits of nodes that share out tiles (Distribution::sortFirst), the lowest first.
std::vector<LimitedNodes> limitsOf(const ScalingFacts& facts);

/// Returns the seconds until `nodes` nodes have the scan, over the links of the coordinator and of the relays. Each
/// link carries it once for every machine at its end; relays pass it on when they have all of it.
double scanSeconds(const ScalingFacts& facts, double nodes);

}  // namespace pdr
