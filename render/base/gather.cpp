#include "render/base/gather.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "render/base/lanes.h"

namespace pdr {

namespace {

using Table = std::array<std::int16_t, 4096>;  ///< 8 kB: fits the first-level cache

/// Returns the time of some hundred gathers [s], four at a time as for a cell of voxels.
template <auto gather>
double secondsOf(const Table& table) {
    IntLanes index{};
    for (int lane = 0; lane < kLanes; ++lane)
        index[lane] = 97 * lane;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 64; ++i) {
        const std::int16_t* from = table.data();
        const IntLanes read =
            gather(from, index) + gather(from + 512, index) + gather(from + 1024, index) + gather(from + 1536, index);
        index = (index + 61 + (read & 1)) & int(table.size() / 2 - 1);
    }
    volatile std::int32_t used = index[0];
    (void)used;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Returns whether gather instructions are at least as fast as single loads. Compares the shortest of several runs
/// each: interruptions only make a run longer.
bool gatherAtOncePays() {
    const Table table{};
    double atOnce = 1e9, oneByOne = 1e9;
    for (int turn = 0; turn < 8; ++turn) {
        atOnce = std::min(atOnce, secondsOf<gatherPairsAtOnce>(table));
        oneByOne = std::min(oneByOne, secondsOf<gatherPairsOneByOne>(table));
    }
    return atOnce <= oneByOne;
}

}  // namespace

const bool kGatherAtOnce = gatherAtOncePays();

}  // namespace pdr
