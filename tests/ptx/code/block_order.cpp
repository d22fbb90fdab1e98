#include "tests/ptx/code/block_order.h"

#include <algorithm>
#include <functional>
#include <map>

namespace pdr::ptx {

namespace {

using Blocks = std::vector<u32>;

Blocks successors(const std::vector<Block>& blocks, u32 b) {
    Blocks next;
    if (blocks[b].end == Block::End::next || blocks[b].end == Block::End::branch)
        next.push_back(b + 1);
    if (blocks[b].target != kNone)
        next.push_back(blocks[b].target);
    return next;
}

/// Searches depth first from block 0. `onEdge(from, to, isBack)` sees each edge, `onEnd(b)` each block once all behind
/// it are done. isBack: `to` is on the way to `from`.
void search(u32 count, const std::function<Blocks(u32)>& next, const std::function<void(u32, u32, bool)>& onEdge,
            const std::function<void(u32)>& onEnd) {
    enum class State : u8 { unseen, onTheWay, done };
    struct Step {
        u32 block;
        Blocks next;
        std::size_t taken = 0;
    };
    std::vector<State> state(count, State::unseen);
    std::vector<Step> way;
    const auto enter = [&](u32 b) {
        state[b] = State::onTheWay;
        way.push_back({b, next(b)});
    };
    enter(0);
    while (!way.empty()) {
        Step& step = way.back();
        if (step.taken == step.next.size()) {
            state[step.block] = State::done;
            onEnd(step.block);
            way.pop_back();
            continue;
        }
        const u32 to = step.next[step.taken++];
        onEdge(step.block, to, state[to] == State::onTheWay);
        if (state[to] == State::unseen)
            enter(to);
    }
}

/// Returns how many loops each block is in. A loop: what lies between its head and the edges back to it.
std::vector<int> loopDepths(const std::vector<Block>& blocks) {
    const u32 count = u32(blocks.size());
    std::vector<Blocks> before(count);
    std::map<u32, Blocks> endsOf;  ///< by the loop's head
    search(
        count, [&](u32 b) { return successors(blocks, b); },
        [&](u32 from, u32 to, bool isBack) {
            before[to].push_back(from);
            if (isBack)
                endsOf[to].push_back(from);
        },
        [](u32) {});
    std::vector<int> depths(count, 0);
    for (auto& [head, open] : endsOf) {
        std::vector<u8> inside(count, 0);
        inside[head] = 1;
        while (!open.empty()) {
            const u32 b = open.back();
            open.pop_back();
            if (std::exchange(inside[b], u8(1)) == 0)
                open.insert(open.end(), before[b].begin(), before[b].end());
        }
        for (u32 b = 0; b < count; ++b)
            depths[b] += inside[b];
    }
    return depths;
}

}  // namespace

std::vector<u32> meetingOrder(const std::vector<Block>& blocks) {
    const std::vector<int> depths = loopDepths(blocks);
    Blocks order;
    search(
        u32(blocks.size()),
        [&](u32 b) {
            Blocks next = successors(blocks, b);
            std::ranges::stable_sort(next, {}, [&](u32 to) { return depths[to]; });
            return next;
        },
        [](u32, u32, bool) {}, [&](u32 b) { order.push_back(b); });
    std::ranges::reverse(order);
    return order;
}

}  // namespace pdr::ptx
