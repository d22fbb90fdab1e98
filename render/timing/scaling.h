#pragma once
/// Predicts what many nodes make of one node's times: frame rate, latency, efficiency and bytes for several ways to
/// distribute frames. The ways are named after Molnar et al., "A Sorting Classification of Parallel Rendering", 1994;
/// the times of a node are those of efficiency.h. Times are in seconds. All nodes are equal, and nothing fails.
/// scaled() describes the model.

#include <cstdint>

#include "render/timing/efficiency.h"
#include "render/timing/tile_costs.h"

namespace pdr {

enum class Distribution {
    sortFirst,          ///< tiles: each node renders its own pixels
    sampleFirst,        ///< each node renders its own samples of every pixel, in whole blocks of kSamplesPerBlock
    sampleFirstInTree,  ///< as sampleFirst, but nodes add up the sums on the way
    alternateFrames,    ///< each node renders its own frames
    sortLast,           ///< each node renders its own brick of the volume
};
inline constexpr int kDistributions = 5;

struct Link {
    double latency = 100e-6;        ///< l, latency of a message, one way
    double bytesPerSecond = 125e6;  ///< W, of the link; 1 Gbit/s
    double messageSeconds = 20e-6;  ///< o, cost of a message for the coordinator
};

struct ScalingFacts {
    FrameTimeModel node;  ///< fitted times of one node alone
    FrameWork work;       ///< work of a frame
    TileCosts tiles;
    double tilesPerNode = 8;       ///< requested; >= 1
    double leastTilePixels = 256;  ///< least size of a tile: nodes beyond pixels / this have nothing to do; >= 1
    Link link;
    double pixelBytes = 25;     ///< a finished pixel from a node: mean and variance of up to 1024 samples, packed; > 0
    double orderBytes = 0.5;    ///< requests and what goes with them, per finished pixel; > 0
    double sumBytes = 18;       ///< a pixel's sums of a block, to which others add, packed
    double checkedPart = 0.02;  ///< part of the samples that a second node takes, to check the first; from 0 to 1
    double relays = 0;          ///< machines between coordinator and nodes, which pass on the scan; 0: none
    double scanBytes = 72e6;    ///< a scan on the wire: 512 x 512 x 600 voxels, packed; >= 0

    /// Returns the facts of one of `nodes` nodes, whose samples include those that it takes to check others.
    ScalingFacts withChecks(double nodes) const {
        ScalingFacts facts = *this;
        facts.node.sample *= nodes > 1 ? 1 + checkedPart : 1;
        return facts;
    }
};

struct ScaledFrames {
    double nodes = 1;
    double busy = 1;  ///< nodes that have work
    double framesPerSecond = 0;
    double latency = 0;     ///< from the request of a frame to its completion
    double efficiency = 0;  ///< fraction of all nodes' time with samples at full speed: n alpha R FPS / nodes
    double paper = 0;       ///< efficiency of many nodes by Perez Monte et al., eq. 5: 1 - FPS T_c
    double bytes = 0;       ///< per frame, over all links
    double messages = 0;    ///< per frame, both ways
};

/// Returns the figures of `nodes` nodes that share frames out in the way `how`. The network is a star: every result
/// goes over one link to the coordinator, which shows the image and hands out work. A node that has ended a tile gets
/// the next one for its result. From eight tiles per node on (sixteen if tiles deviate from their mean by more than
/// it), the formulas are within 5 % of an event-by-event simulation (tests/app/bench/star_simulation_test.cpp), except
/// where nodes and link are about equally slow: there each waits for the other in turn.
///   l  latency of a message, one way    W  bytes per second of the link    o  cost of a message for the coordinator
///   k  tiles per node                   s = bytes of a result / W + o      t  time of a tile or other piece
ScaledFrames scaled(const ScalingFacts& facts, Distribution how, double nodes);

/// How sort-first cuts a frame for a number of nodes.
struct TileCut {
    double nodes;         ///< nodes that have work
    double tilesPerNode;  ///< a whole number
    double pixels;        ///< per tile
    double floorSeconds;  ///< per tile: ceil(n / b) T0
    double workSeconds;   ///< mean per tile: (n alpha + beta) pixels

    double tileSeconds() const { return floorSeconds + workSeconds; }
};
TileCut tileCut(const ScalingFacts& facts, double nodes);

/// Returns the pixels of a tile that takes as long to launch as to sample: T0 ceil(n / b) / (n alpha). Infinite without
/// samples.
double floorPixels(const FrameTimeModel& node, const FrameWork& work);
/// Returns the number of nodes from which on sort-first's tiles are smaller than floorPixels(); infinite if no tile
/// ever is.
double floorNodes(const ScalingFacts& facts);

}  // namespace pdr
