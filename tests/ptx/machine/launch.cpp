#include "tests/ptx/machine/launch.h"

#include <algorithm>

namespace pdr::ptx {

namespace {

constexpr int kToTheEnd = 1 << 30;  ///< blocks of instructions
constexpr int kTurn = 100;
constexpr int kLongestTurn = 300;

}  // namespace

void runLaunch(Launch& launch, std::vector<Warp>& warps) {
    const Warps way = launch.settings.warps;
    const u32 perBlock = u32((launch.block.count() + kLanes - 1) / kLanes);
    const u64 all = launch.grid.count() * perBlock;
    const std::size_t together = std::min(way == Warps::inOrder ? 1 : launch.settings.together, all);
    warps.resize(std::max(warps.size(), together));
    u64 next = 0;
    const auto startNext = [&](Warp& warp) {
        warp.start(next / perBlock, u32(next % perBlock));
        ++next;
    };
    std::vector<Warp*> going;
    for (std::size_t n = 0; n < together; ++n) {
        warps[n].prepare(launch);
        startNext(warps[n]);
        going.push_back(&warps[n]);
    }
    for (std::size_t turn = 0; !going.empty(); ++turn) {
        const std::size_t chosen = way == Warps::atRandom ? launch.random() % going.size() : turn % going.size();
        const int blocks = way == Warps::inOrder    ? kToTheEnd
                           : way == Warps::atRandom ? 1 + int(launch.random() % kLongestTurn)
                                                    : kTurn;
        Warp& warp = *going[chosen];
        if (warp.run(blocks))
            continue;
        if (next < all)
            startNext(warp);
        else
            going.erase(going.begin() + std::ptrdiff_t(chosen));
    }
}

}  // namespace pdr::ptx
