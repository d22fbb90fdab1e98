#pragma once
/// How a picture is shared out among nodes: by tiles (sort-first), or by samples (every node whole blocks of all
/// pixels). A tile costs a node something before its first sample, however small it is: where that is more than the
/// tile's samples, whole pictures pay it less often.

#include <cstdint>

#include "render/base/split.h"
#include "render/base/text.h"

namespace pdr {

struct SplitFacts {
    double pixels = 0;          ///< R of the picture
    std::uint64_t samples = 0;  ///< ordered, of each pixel
    int nodes = 1;              ///< that take samples; a coordinator that does so itself is one of them
    double sampleSeconds = 0;   ///< alpha: of a sample of a pixel on one node
    double launchSeconds = 0;   ///< T0: before the first sample of a piece of work
    double latencySeconds = 0;  ///< l: of a message, one way
    double bytesPerSecond = 0;  ///< W, into the coordinator; 0: nothing is known, and nothing waits for it
    double bytesPerPixel = 0;   ///< of a result: sums of one block of samples
};

struct SplitChoice {
    Split split = Split::tiles;
    Text reason;             ///< for the user: "tiles would be smaller than what a node needs to start: 0.8 ms of 2 ms"
    double workSeconds = 0;  ///< of one tile's samples of a block, where each node has one
    double startSeconds = 0;    ///< before them: T0 + 2 l
    double tilesSeconds = 0;    ///< foretold for all samples
    double samplesSeconds = 0;  ///< likewise; as tilesSeconds where samples cannot be shared
};

/// Samples where tiles would be smaller than what a node needs to start, and where they are foretold to be sooner:
///   tiles    ceil(n / 64) (T0 + 2 l) + n alpha R / m                 m nodes, B = n / 64 blocks
///   samples  ceil(B / m) (T0 + 2 l + 64 alpha R)
/// neither before the link has brought all sums. Only whole blocks of kSamplesPerBlock can be shared: n has to hold
/// two.
SplitChoice chooseSplit(const SplitFacts& facts);

}  // namespace pdr
