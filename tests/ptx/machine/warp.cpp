#include "tests/ptx/machine/warp.h"

#include <algorithm>

namespace pdr::ptx {

namespace {

constexpr int kLaunchFailure = 719;  ///< cudaErrorLaunchFailure

}  // namespace

std::string Warp::placeOf(const Instruction& i) const {
    return launch->program.text.name + ", PTX line " + std::to_string(i.line) + " (" + i.text + ")";
}

void Warp::fault(const Instruction& i, int lane, int status, const std::string& what) const {
    throw DeviceFault(status, placeOf(i) + ", thread " + std::to_string(accessor(lane).thread) + ": " + what);
}

void Warp::tell(const Instruction& i, const std::string& what) const {
    launch->findings.tell(placeOf(i) + ": " + what);
}

/// Groups that wait at a meeting for other lanes are passed over.
std::size_t Warp::nextGroup() {
    const std::vector<Block>& blocks = launch->program.blocks;
    u32 alive = 0;
    for (const Group& group : groups)
        alive |= group.mask;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const u32 members = blocks[groups[i].block].memberMask;
        if (members == kNone || (at<u32>(members)[__builtin_ctz(groups[i].mask)] & alive) == groups[i].mask)
            return i;
    }
    throw DeviceFault(kLaunchFailure, launch->program.text.name + ": lanes wait for each other at " +
                                          std::to_string(groups.size()) + " places");
}

void Warp::enter(u32 block, u32 lanes) {
    const std::vector<Block>& blocks = launch->program.blocks;
    const auto at = std::ranges::find_if(
        groups, [&](const Group& group) { return blocks[group.block].order >= blocks[block].order; });
    if (at != groups.end() && at->block == block)
        at->mask |= lanes;
    else
        groups.insert(at, {block, lanes});
}

void Warp::leave(const Block& block, u32 number) {
    switch (block.end) {
        case Block::End::exit:
            return;
        case Block::End::next:
            return enter(number + 1, mask);
        case Block::End::jump:
            return enter(block.target, mask);
        case Block::End::branch:
            break;
    }
    const u32 bits = predicates[block.predicate];
    const u32 taken = mask & (block.predicateNot ? ~bits : bits), rest = mask & ~taken;
    if (taken != 0 && !block.exits)
        enter(block.target, taken);
    if (rest != 0)
        enter(number + 1, rest);
}

void Warp::runBlock(const Block& block) {
    const u32 all = mask;
    const Instruction* last = launch->program.instructions.data() + block.last;
    for (const Instruction* i = launch->program.instructions.data() + block.first; i != last; ++i) {
        if (i->guard == kNone) [[likely]] {
            i->run(*this, *i);
            continue;
        }
        mask = all & (i->guardNot ? ~predicates[i->guard] : predicates[i->guard]);
        if (mask != 0)
            i->run(*this, *i);
        mask = all;
    }
}

bool Warp::run(int blocks) {
    const std::vector<Block>& all = launch->program.blocks;
    for (; blocks > 0 && !groups.empty(); --blocks) {
        const bool isAlone = groups.size() == 1 && all[groups[0].block].memberMask == kNone;
        const std::size_t next = isAlone ? 0 : nextGroup();
        const Group group = groups[next];
        groups.erase(groups.begin() + std::ptrdiff_t(next));
        mask = group.mask;
        BlockCounts& counts = launch->counts[group.block];
        ++counts.warps;
        counts.lanes += u64(__builtin_popcount(mask));
        runBlock(all[group.block]);
        leave(all[group.block], group.block);
    }
    return !groups.empty();
}

}  // namespace pdr::ptx
