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

/// Asked for, computed, sent, taken in.
double roundTrip(const Link& link, double bytes) {
    return 2 * link.latency + resultSeconds(link, bytes);
}

/// What a frame costs that comes whole from one node.
FrameWork wholeFrame(const ScalingFacts& facts, double iterations) {
    FrameWork work = facts.work;
    work.iterations = std::uint32_t(iterations);
    return work;
}

/// A frame in pieces that go through the star, and the node that ends last.
struct StarFrame {
    double working;  ///< seconds of that node, in all its pieces
    double pieces;   ///< of that node
    double crowd;    ///< results of others that come together with its own, and before it
    double first;    ///< seconds of the piece that ends first
    double results;  ///< of the frame
    double bytes;    ///< of a result
};

/// T = T_c + working + (pieces - 1) (2 l + s), and a crowd's results once. A frame's results come while the next is
/// made: FPS = 1 / max(T, all results s). Latency: T and the ways there and back; or the first result, then the link.
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

/// Perez Monte et al., eq. 2, for m nodes with k tiles each, with a floor for every launch and the last node's
/// overhang: working = k lambda_b (ceil(n / b) T0 + (n alpha + beta) R / (k m))
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

/// Blocks of samples of the whole picture, each sent as sums, which are made one picture in the end: with B blocks
/// working = ceil(B / m) (T0 launches of a block + 64 alpha R), less where the last wave is the rest of the samples
/// alone; and beta R of the one who shows
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

/// The sums of all nodes are added up by recursive halving and gathered (Thakur, Rabenseifner & Gropp, "Optimization
/// of Collective Communication Operations in MPICH", 2005, reduce): 2 (m - 1) / m of a picture's sums a node and
/// 2 log2(m) messages one after the other; before the next frame.
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

/// FPS = m / (T + 2 l + s) until the link has enough, 1 / s; latency of a frame alone, whatever m is.
ScaledFrames alternateFrames(const ScalingFacts& facts, double nodes) {
    const double bytes = facts.work.pixels * facts.pixelBytes;
    const double cycle = frameSeconds(facts.node, facts.work) + roundTrip(facts.link, bytes);
    const double most = 1 / resultSeconds(facts.link, bytes);
    ScaledFrames frames{.busy = nodes};
    frames.framesPerSecond = std::min(nodes / cycle, most);
    // Where the link has enough, frames wait for it: as many are on their way as there are nodes (Little's law).
    frames.latency = std::max(cycle, nodes / most);
    frames.bytes = bytes;
    frames.messages = 2;
    return frames;
}

/// Free flights forget where they began, so each node finds the first event in its own brick, which covers R / m^(2/3)
/// pixels; the nearest one counts, is told to all, and each answers with its brick's transmittance. 28 bytes of a
/// sample of a pixel in all: (t, id, weight), the place, the transmittance. Composited by binary swap (Ma, Painter,
/// Hansen & Krogh, "Parallel volume rendering using binary-swap compositing", 1994), twice: log2(m) messages each a
/// launch.
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
    ScaledFrames frames = framesOf(facts, how, nodes);
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
