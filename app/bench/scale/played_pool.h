#pragma once
/// Plays an image with the program's own division of the work (render/tiles/pool_state.h), on a clock of its own, among
/// nodes that render nothing: how many results they send, and of how many pixels. Pieces of work differ with the number
/// of nodes and their speed: of more or slower nodes each takes fewer pixels and fewer blocks, and a node that is new
/// begins with parts of a block.

#include <cstdint>

#include "render/base/portable.h"

namespace pdr::bench::scale {

/// Nodes that are all alike, beside a coordinator that renders only what nobody else may.
struct PlayedNodes {
    int count = 1;
    double sampleSeconds = 1e-6;  ///< mean time of a node for a sample of a pixel; > 0
    double leaseSeconds = 0;      ///< time of a node for a lease beside its samples
    double tissue = 1;            ///< part of the image that shows tissue, in its middle; (0, 1]
};

struct PlayedResults {
    double merged = 0;      ///< results that the film takes from nodes
    double sent = 0;        ///< these, and what nodes send to check each other
    double sumPixels = 0;   ///< pixels of tissue of all results of one block, each of which has sums
    double deepPixels = 0;  ///< pixels of tissue of all results of several blocks, each of which has moments
};

/// Returns the results of an image for a file. All pixels of tissue cost the same, and all others.
PlayedResults playedResults(ivec2 size, std::uint64_t samples, const PlayedNodes& nodes);

}  // namespace pdr::bench::scale
