#pragma once
/// Limits on a lease, the unit of work of a render node. The division of the work keeps them, and messages that exceed
/// them are refused.

#include <cstddef>
#include <cstdint>

#include "render/base/tile.h"

namespace pdr {

/// Returns whether these samples are those of several whole blocks: then moments are continued and returned, once for
/// all blocks, instead of the sums of one block.
inline bool isDeep(SampleRange samples) {
    return samples.count > kSamplesPerBlock;
}

/// Limits on the pixels of a lease, which bound the memory and the message of its result: of one block, and of several.
inline constexpr std::size_t kMostLeasePixels = 512 * 512, kMostDeepPixels = kMostLeasePixels / 2;
/// Limit on the samples of a deep lease.
inline constexpr std::uint32_t kMostDeepSamples = 1 << 16;

}  // namespace pdr
