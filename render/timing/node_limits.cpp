#include "render/timing/node_limits.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

/// With k tiles a node, m nodes send k m results a frame and make frames m times as fast as one, so messages grow with
/// the square of m.
double nodesOfMessages(const ScalingFacts& facts, double frameSeconds) {
    return std::sqrt(frameSeconds / (facts.tilesPerNode * facts.link.messageSeconds));
}

}  // namespace

std::vector<LimitedNodes> limitsOf(const ScalingFacts& facts) {
    constexpr double kMany = 2;  // nodes, so that they check each other
    const double seconds = frameSeconds(facts.withChecks(kMany).node, facts.work);
    const double linkPixels = facts.link.bytesPerSecond * seconds / facts.work.pixels;  // a frame's, byte by byte
    std::vector<LimitedNodes> limits{
        {NodeLimit::results, linkPixels / facts.pixelBytes},
        {NodeLimit::orders, linkPixels / facts.orderBytes},
        {NodeLimit::messages, nodesOfMessages(facts, seconds)},
        {NodeLimit::tiles, std::floor(facts.work.pixels / facts.leastTilePixels)},
    };
    std::ranges::sort(limits, {}, &LimitedNodes::nodes);
    return limits;
}

double scanSeconds(const ScalingFacts& facts, double nodes) {
    const auto to = [&](double machines) {
        return facts.link.latency + machines * facts.scanBytes / facts.link.bytesPerSecond;
    };
    return facts.relays > 0 ? to(facts.relays) + to(std::ceil(nodes / facts.relays)) : to(nodes);
}

}  // namespace pdr
