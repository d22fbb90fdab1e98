#include "render/timing/scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/base/tile.h"

namespace pdr {

namespace {

double resultSeconds(const Link& link, double bytes) {
    return bytes / link.bytesPerSecond + link.messageSeconds;
}

/// Returns the time to request a piece of work, send its result and take it in; computing it is not included.
double roundTrip(const Link& link, double bytes) {
    return 2 * link.latency + resultSeconds(link, bytes);
}

/// Returns the work of a frame that one node renders whole, with that many iterations.
FrameWork wholeFrame(const ScalingFacts& facts, double iterations) {
    FrameWork work = facts.work;
    work.iterations = std::uint32_t(iterations);
    return work;
}

/// A frame in pieces that go through the star, and the node that ends last.
struct StarFrame {
    double working;  ///< seconds of the last node, in all its pieces
    double pieces;   ///< pieces of the last node
    double crowd;    ///< results of other nodes that come together with its own, and before it
    double first;    ///< seconds of the piece that ends first
    double results;  ///< results per frame
    double bytes;    ///< bytes per result
};

/// Returns the frames of a star. T = T_c + working + (pieces - 1) (2 l + s), and a crowd's results once. A frame's
/// results come while the next one is rendered: FPS = 1 / max(T, all results s). Latency: T and the ways there and
/// back; or the first result, then the time of the link for all results.
ScaledFrames throughStar(const ScalingFacts& facts, const StarFrame& frame) {
    const double taking = resultSeconds(facts.link, frame.bytes), crowd = frame.crowd * taking;
    const double alone =
        facts.node.communication + frame.working + (frame.pieces - 1) * roundTrip(facts.link, frame.bytes);
    ScaledFrames frames;
    frames.framesPerSecond = 1 / std::max(alone + (frame.pieces > 1 ? crowd : 0), frame.results * taking);
    frames.latency = 2 * facts.link.latency +
                     std::max(alone + crowd + taking, facts.node.communication + frame.first + frame.results * taking);
    frames.bytes = frame.results * frame.bytes;
    frames.messages = 2 * frame.results;
    return frames;
}

/// Sort-first: Perez Monte et al., eq. 2, for m nodes with k tiles each, with a time T0 for every launch and the last
/// node's overhang: working = k lambda_b (ceil(n / b) T0 + (n alpha + beta) R / (k m))
ScaledFrames sortFirst(const ScalingFacts& facts, double nodes) {
    const TileCut cut = tileCut(facts, nodes);
    const TileCosts costs = facts.tiles.diluted(cut.workSeconds / cut.tileSeconds());
    StarFrame frame;
    frame.working = cut.tilesPerNode * cut.tileSeconds() * imbalance(costs, cut.nodes, cut.tilesPerNode);
    frame.pieces = cut.tilesPerNode;
    frame.crowd = inStep(costs, cut.nodes, cut.tilesPerNode) ? cut.nodes - 1 : 0;
    frame.first = costs.sorted().front() * cut.tileSeconds();
    frame.results = cut.nodes * cut.tilesPerNode;
    frame.bytes = cut.pixels * facts.pixelBytes;
    ScaledFrames frames = throughStar(facts, frame);
    frames.busy = cut.nodes;
    return frames;
}

/// Sample-first: blocks of samples of the whole image, each sent as sums, which are combined into one image in the end.
/// With B blocks, working = ceil(B / m) (T0 launches of a block + 64 alpha R), less if the last wave is only the
/// rest of the samples; plus beta R of the coordinator.
ScaledFrames sampleFirst(const ScalingFacts& facts, double nodes) {
    const double blocks = std::ceil(double(facts.work.iterations) / kSamplesPerBlock), busy = std::min(nodes, blocks);
    FrameTimeModel sampling = facts.node;
    sampling.pixel = sampling.communication = 0;
    const auto seconds = [&](double samples) { return frameSeconds(sampling, wholeFrame(facts, samples)); };
    const double rest = facts.work.iterations - (blocks - 1) * kSamplesPerBlock;
    StarFrame frame;
    frame.first = seconds(blocks > 1 ? kSamplesPerBlock : rest);
    frame.pieces = std::ceil(blocks / busy);
    frame.crowd = blocks - busy * (frame.pieces - 1) - 1;
    frame.working = (frame.pieces - 1) * frame.first + (frame.crowd > 0 ? frame.first : seconds(rest));
    frame.results = blocks;
    frame.bytes = facts.work.pixels * facts.sumBytes;
    ScaledFrames frames = throughStar(facts, frame);
    const double showing = facts.node.pixel * facts.work.pixels;
    frames.framesPerSecond =
        std::min(frames.framesPerSecond, 1 / (frame.results * resultSeconds(facts.link, frame.bytes) + showing));
    frames.latency += showing;
    frames.busy = busy;
    return frames;
}

/// Sample-first in a tree: the sums of all nodes are added up by recursive halving and gathered (Thakur, Rabenseifner &
/// Gropp, "Optimization of Collective Communication Operations in MPICH", 2005, reduce), before the next frame:
/// 2 (m - 1) / m of an image's sums per node and 2 log2(m) messages one after the other.
ScaledFrames sampleFirstInTree(const ScalingFacts& facts, double nodes) {
    const double blocks = std::ceil(double(facts.work.iterations) / kSamplesPerBlock), busy = std::min(nodes, blocks);
    const double own = std::min(std::ceil(blocks / busy) * kSamplesPerBlock, double(facts.work.iterations));
    const double steps = 2 * std::ceil(std::log2(busy)), bytes = facts.work.pixels * facts.sumBytes;
    const double reducing = steps * (facts.link.latency + facts.link.messageSeconds) +
                            2 * (busy - 1) / busy * bytes / facts.link.bytesPerSecond;
    ScaledFrames frames{.busy = busy};
    const double seconds = frameSeconds(facts.node, wholeFrame(facts, own)) + reducing;
    frames.framesPerSecond = 1 / seconds;
    frames.latency = seconds + 2 * facts.link.latency;
    frames.bytes = 2 * (busy - 1) * bytes;
    frames.messages = busy * steps;
    return frames;
}

/// Alternate frames: FPS = m / (T + 2 l + s) until the link is saturated, 1 / s. Until then the latency is that of a
/// frame alone, whatever m is.
ScaledFrames alternateFrames(const ScalingFacts& facts, double nodes) {
    const double bytes = facts.work.pixels * facts.pixelBytes;
    const double cycle = frameSeconds(facts.node, facts.work) + roundTrip(facts.link, bytes);
    const double most = 1 / resultSeconds(facts.link, bytes);
    ScaledFrames frames{.busy = nodes};
    frames.framesPerSecond = std::min(nodes / cycle, most);
    // If the link is saturated, frames wait for it: as many are on their way as there are nodes (Little's law)
    frames.latency = std::max(cycle, nodes / most);
    frames.bytes = bytes;
    frames.messages = 2;
    return frames;
}

/// Sort-last: free flights have no memory of where they began, so each node finds the first event in its own brick,
/// which covers R / m^(2/3) pixels. The nearest event counts and is sent to all nodes, and each answers with its
/// brick's transmittance: 28 bytes per sample of a pixel in all, for (t, id, weight), the position and the
/// transmittance. They are composited by binary swap (Ma, Painter, Hansen & Krogh, "Parallel volume rendering using
/// binary-swap compositing", 1994), twice: log2(m) messages each per launch.
ScaledFrames sortLast(const ScalingFacts& facts, double nodes) {
    constexpr double kBytes = 28;
    const double samples = facts.work.iterations * facts.work.pixels, launches = facts.work.launches();
    const double sampling = launches * facts.node.launch + facts.node.sample * samples / std::cbrt(nodes * nodes);
    const double steps = 2 * std::ceil(std::log2(nodes)) * launches;
    const double compositing = steps * (facts.link.latency + facts.link.messageSeconds) +
                               kBytes * samples * (nodes - 1) / nodes / facts.link.bytesPerSecond;
    ScaledFrames frames{.busy = nodes};
    const double seconds =
        sampling + compositing + facts.node.pixel * facts.work.pixels / nodes + facts.node.communication;
    frames.framesPerSecond = 1 / seconds;
    frames.latency = seconds + 2 * facts.link.latency;
    frames.bytes = kBytes * samples * (nodes - 1) / nodes + facts.work.pixels * facts.pixelBytes;
    frames.messages = nodes * steps;
    return frames;
}

ScaledFrames framesOf(const ScalingFacts& facts, Distribution how, double nodes) {
    switch (how) {
        case Distribution::sortFirst:
            return sortFirst(facts, nodes);
        case Distribution::sampleFirst:
            return sampleFirst(facts, nodes);
        case Distribution::sampleFirstInTree:
            return sampleFirstInTree(facts, nodes);
        case Distribution::alternateFrames:
            return alternateFrames(facts, nodes);
        case Distribution::sortLast:
            return sortLast(facts, nodes);
    }
    return {};
}

}  // namespace

TileCut tileCut(const ScalingFacts& facts, double nodes) {
    const double most = std::max(1.0, std::floor(facts.work.pixels / facts.leastTilePixels));
    const double busy = std::min(nodes, most);
    const double tiles = std::clamp(std::floor(most / busy), 1.0, facts.tilesPerNode);
    const double pixels = facts.work.pixels / (busy * tiles);
    return {busy, tiles, pixels, facts.work.launches() * facts.node.launch,
            (facts.work.iterations * facts.node.sample + facts.node.pixel) * pixels};
}

ScaledFrames scaled(const ScalingFacts& facts, Distribution how, double nodes) {
    ScaledFrames frames = framesOf(facts.withChecks(nodes), how, nodes);
    frames.nodes = nodes;
    frames.efficiency = facts.work.iterations * facts.node.sample * facts.work.pixels * frames.framesPerSecond / nodes;
    frames.paper = efficiencyOfManyNodes(frames.framesPerSecond, facts.node.communication);
    return frames;
}

double floorPixels(const FrameTimeModel& node, const FrameWork& work) {
    const double perPixel = work.iterations * node.sample;
    return perPixel > 0 ? work.launches() * node.launch / perPixel : std::numeric_limits<double>::infinity();
}

double floorNodes(const ScalingFacts& facts) {
    const double pixels = std::max(floorPixels(facts.node, facts.work), 1e-300);
    const double nodes = facts.work.pixels / (facts.tilesPerNode * pixels);
    return pixels < facts.leastTilePixels ? std::numeric_limits<double>::infinity() : nodes;
}

}  // namespace pdr
