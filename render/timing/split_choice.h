#pragma once
/// Chooses how an image is distributed among nodes: by tiles (sort-first), or by samples (every node renders whole
/// blocks of all pixels). A node needs some time before the first sample of a tile, however small the tile is. If that
/// exceeds the time of the tile's samples, whole images pay it less often.

#include <cstdint>

#include "render/base/split.h"
#include "render/base/text.h"

namespace pdr {

struct SplitFacts {
    double pixels = 0;          ///< R of the image
    std::uint64_t samples = 0;  ///< requested samples per pixel
    int nodes = 1;              ///< nodes that take samples, including the coordinator if it does
    double sampleSeconds = 0;   ///< alpha: time of a sample of a pixel on one node
    double launchSeconds = 0;   ///< T0: time before the first sample of a piece of work
    double latencySeconds = 0;  ///< l: latency of a message, one way
    double bytesPerSecond = 0;  ///< W, into the coordinator; 0: unknown, not a limit
    double bytesPerPixel = 0;   ///< bytes of a result per pixel: sums of one block of samples
};

struct SplitChoice {
    Split split = Split::tiles;
    Text reason;             ///< for the user: "tiles would be smaller than what a node needs to start: 0.8 ms of 2 ms"
    double workSeconds = 0;  ///< time of one tile's samples of a block, if each node has one tile
    double startSeconds = 0;    ///< time before them: T0 + 2 l
    double tilesSeconds = 0;    ///< predicted time of all samples by tiles
    double samplesSeconds = 0;  ///< predicted time by samples; tilesSeconds if samples cannot be shared
};

/// Chooses samples if tiles would be smaller than what a node needs to start and samples are predicted to be sooner:
///   tiles    ceil(n / 64) (T0 + 2 l) + n alpha R / m                 m nodes, B = n / 64 blocks
///   samples  ceil(B / m) (T0 + 2 l + 64 alpha R)
/// Neither ends before the link has transferred all sums. Only whole blocks of kSamplesPerBlock can be shared: n must
/// hold two.
SplitChoice chooseSplit(const SplitFacts& facts);

}  // namespace pdr
