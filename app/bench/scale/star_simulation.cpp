#include "app/bench/scale/star_simulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <random>

#include "render/base/tile.h"

namespace pdr::bench::scale {

namespace {

constexpr double kPiecesForAMean = 20'000;
constexpr int kMostFrames = 64;

/// Returns the seconds of each tile. Costs are drawn with replacement and then scaled to a mean of 1, because the whole
/// image has a fixed cost.
std::vector<double> tilePieces(const TileCut& cut, const TileCosts& costs, std::mt19937& random) {
    std::vector<double> drawn(std::size_t(cut.nodes * cut.tilesPerNode));
    for (double& cost : drawn)
        cost = costs.sorted()[random() % costs.sorted().size()];
    const double mean = std::accumulate(drawn.begin(), drawn.end(), 0.0) / double(drawn.size());
    for (double& cost : drawn)
        cost = cut.floorSeconds + cut.workSeconds * (mean > 0 ? cost / mean : 1);
    return drawn;
}

ScaledFrames inParts(const ScalingFacts& facts, ScaledFrames frames, double nodes) {
    frames.nodes = nodes;
    frames.efficiency = facts.work.iterations * facts.node.sample * facts.work.pixels * frames.framesPerSecond / nodes;
    frames.paper = efficiencyOfManyNodes(frames.framesPerSecond, facts.node.communication);
    return frames;
}

ScaledFrames tiles(const ScalingFacts& facts, std::int64_t nodes, std::uint32_t seed) {
    const TileCut cut = tileCut(facts, double(nodes));
    const double pieces = cut.nodes * cut.tilesPerNode;
    const int count = int(std::clamp(std::ceil(kPiecesForAMean / pieces), 1.0, double(kMostFrames)));
    std::mt19937 random(seed);
    double period = 0, latency = 0;
    for (int frame = 0; frame < count; ++frame) {
        const StarTimes times = play({tilePieces(cut, facts.tiles, random), std::int64_t(cut.nodes),
                                      facts.node.communication, facts.link, cut.pixels * facts.pixelBytes});
        period += std::max(times.computed, times.link) / count;
        latency += times.latency / count;
    }
    ScaledFrames frames{.busy = cut.nodes, .framesPerSecond = 1 / period, .latency = latency};
    frames.bytes = facts.work.pixels * facts.pixelBytes;
    frames.messages = 2 * pieces;
    return frames;
}

ScaledFrames blocks(const ScalingFacts& facts, std::int64_t nodes) {
    FrameTimeModel sampling = facts.node;
    sampling.pixel = sampling.communication = 0;
    std::vector<double> pieces;
    for (std::uint32_t done = 0; done < facts.work.iterations; done += kSamplesPerBlock) {
        FrameWork block = facts.work;
        block.iterations = std::min(facts.work.iterations - done, kSamplesPerBlock);
        pieces.push_back(frameSeconds(sampling, block));
    }
    const double count = double(pieces.size());
    const double bytes = facts.work.pixels * facts.sumBytes, showing = facts.node.pixel * facts.work.pixels;
    const StarTimes times = play({std::move(pieces), nodes, facts.node.communication, facts.link, bytes});
    ScaledFrames frames{.busy = std::min(double(nodes), count)};
    frames.framesPerSecond = 1 / std::max(times.computed, times.link + showing);
    frames.latency = times.latency + showing;
    frames.bytes = count * bytes;
    frames.messages = 2 * count;
    return frames;
}

/// Simulates sixteen frames of every node.
ScaledFrames alternating(const ScalingFacts& facts, std::int64_t nodes) {
    const double count = 16.0 * double(nodes), bytes = facts.work.pixels * facts.pixelBytes;
    const StarTimes times = play(
        {std::vector<double>(std::size_t(count), frameSeconds(facts.node, facts.work)), nodes, 0, facts.link, bytes});
    ScaledFrames frames{.busy = double(nodes), .framesPerSecond = count / times.latency};
    frames.latency = double(nodes) / frames.framesPerSecond;  // Little's law
    frames.bytes = bytes;
    frames.messages = 2;
    return frames;
}

}  // namespace

StarTimes play(const StarWork& work) {
    const double taking = work.resultBytes / work.link.bytesPerSecond + work.link.messageSeconds;
    // Arrival times of results; all nodes are alike.
    std::priority_queue<double, std::vector<double>, std::greater<>> arrivals;
    StarTimes times;
    std::size_t next = 0;
    const auto order = [&](double at) {
        const double end = at + work.link.latency + work.pieces[next++];
        times.computed = std::max(times.computed, end - work.link.latency);
        arrivals.push(end + work.link.latency);
    };
    for (std::int64_t node = 0; node < work.nodes && next < work.pieces.size(); ++node)
        order(work.setup);
    for (; !arrivals.empty(); times.link += taking) {
        times.latency = std::max(times.latency, arrivals.top()) + taking;
        arrivals.pop();
        if (next < work.pieces.size())
            order(times.latency);
    }
    return times;
}

std::optional<ScaledFrames> simulated(const ScalingFacts& facts, Distribution how, std::int64_t nodes,
                                      std::uint32_t seed) {
    const ScalingFacts checking = facts.withChecks(double(nodes));
    switch (how) {
        case Distribution::sortFirst:
            return inParts(facts, tiles(checking, nodes, seed), double(nodes));
        case Distribution::sampleFirst:
            return inParts(facts, blocks(checking, nodes), double(nodes));
        case Distribution::alternateFrames:
            return inParts(facts, alternating(checking, nodes), double(nodes));
        case Distribution::sampleFirstInTree:
        case Distribution::sortLast:
            break;
    }
    return std::nullopt;
}

}  // namespace pdr::bench::scale
