#pragma once
/// What many nodes make of one node's times: frame rate, latency, efficiency and bytes of ways to share frames out.
/// Molnar et al., "A Sorting Classification of Parallel Rendering", 1994, has the names; the times of a node are those
/// of efficiency.h. Times in seconds. All nodes are alike, and nothing fails.
///
/// A star: every result goes over one link to the one who shows the picture and who hands out work; a node that has
/// ended a tile gets the next one for its result. From eight tiles a node on (sixteen where tiles deviate from their mean
/// by more than it), the formulas are within 5 % of that played event by event (tests/bench/star_simulation_test.cpp),
/// but where nodes and link are about as slow: there each waits for the other in turn.
///   l  latency of a message, one way    W  bytes per second of the link    o  what a message costs who shows
///   k  tiles of a node                  s = bytes of a result / W + o      t  time of a tile or other piece

#include <cstdint>

#include "render/timing/efficiency.h"
#include "render/timing/tile_costs.h"

namespace pdr {

enum class Distribution {
    sortFirst,          ///< tiles: a node has pixels of its own
    sampleFirst,        ///< a node has samples of its own of every pixel, in whole blocks of kSamplesPerBlock
    sampleFirstInTree,  ///< the same, with sums added up among the nodes on the way
    alternateFrames,    ///< a node has frames of its own
    sortLast,           ///< a node has a brick of the volume of its own
};
inline constexpr int kDistributions = 5;

struct Link {
    double latency = 100e-6;        ///< l
    double bytesPerSecond = 125e6;  ///< W; 1 Gbit/s
    double messageSeconds = 20e-6;  ///< o
};

struct ScalingFacts {
    FrameTimeModel node;  ///< of one node alone, fitted
    FrameWork work;       ///< a frame
    TileCosts tiles;
    double tilesPerNode = 8;       ///< wanted; >= 1
    double leastTilePixels = 256;  ///< no tile is smaller, so that nodes beyond pixels / this have nothing to do; >= 1
    Link link;
    double pixelBytes = 4;  ///< of a pixel that is finished: 8 bits a channel
    double sumBytes = 16;   ///< of a pixel to which others add: floats
};

struct ScaledFrames {
    double nodes = 1;
    double busy = 1;  ///< of them, those that have work
    double framesPerSecond = 0;
    double latency = 0;     ///< from the order of a frame to the whole of it
    double efficiency = 0;  ///< part of all nodes' time in which samples are taken at full speed: n alpha R FPS / nodes
    double paper = 0;       ///< what Perez Monte et al., eq. 5, has for it with many nodes: 1 - FPS T_c
    double bytes = 0;       ///< of a frame, over all links
    double messages = 0;    ///< of a frame, both ways
};

ScaledFrames scaled(const ScalingFacts& facts, Distribution how, double nodes);

/// How sort-first cuts a frame for so many nodes.
struct TileCut {
    double nodes;         ///< that have work
    double tilesPerNode;  ///< whole
    double pixels;        ///< of a tile
    double floorSeconds;  ///< of a tile: ceil(n / b) T0
    double workSeconds;   ///< of a tile: (n alpha + beta) pixels, the mean

    double tileSeconds() const { return floorSeconds + workSeconds; }
};
TileCut tileCut(const ScalingFacts& facts, double nodes);

/// A tile of so many pixels takes as long to launch as to sample: T0 ceil(n / b) / (n alpha). Infinite without samples.
double floorPixels(const FrameTimeModel& node, const FrameWork& work);
/// From how many nodes on sort-first's tiles are smaller than that; infinite where no tile ever is.
double floorNodes(const ScalingFacts& facts);

}  // namespace pdr
