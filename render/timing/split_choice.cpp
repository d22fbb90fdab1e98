#include "render/timing/split_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/base/tile.h"

namespace pdr {

namespace {

/// "0.8 ms", "120 ms", "12 s": two digits that count.
std::string shortTime(double seconds) {
    const bool large = seconds >= 1;
    const double value = large ? seconds : 1e3 * seconds;
    const double unit = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 1) : 1;
    char text[32];
    std::snprintf(text, sizeof text, "%g %s", std::round(value / unit) * unit, large ? "s" : "ms");
    return text;
}

SplitChoice tilesSince(SplitChoice choice, std::string reason) {
    choice.reason = std::move(reason);
    return choice;
}

}  // namespace

SplitChoice chooseSplit(const SplitFacts& facts) {
    const double nodes = std::max(1, facts.nodes), block = std::min<double>(double(facts.samples), kSamplesPerBlock);
    const double blocks = std::ceil(double(facts.samples) / kSamplesPerBlock);
    const double inBlock = block * facts.sampleSeconds * facts.pixels;
    const double link =
        facts.bytesPerSecond > 0 ? blocks * facts.pixels * facts.bytesPerPixel / facts.bytesPerSecond : 0;
    SplitChoice choice;
    choice.workSeconds = inBlock / nodes;
    choice.startSeconds = facts.launchSeconds + 2 * facts.latencySeconds;
    const double byTiles =
        blocks * choice.startSeconds + double(facts.samples) * facts.sampleSeconds * facts.pixels / nodes;
    choice.tilesSeconds = choice.samplesSeconds = std::max(byTiles, link);
    if (nodes < 2)
        return tilesSince(choice, "one node has the whole picture");
    if (facts.samples < 2 * kSamplesPerBlock)
        return tilesSince(choice, "samples are shared out in blocks of 64, and fewer than two are ordered");
    const double bySamples = std::ceil(blocks / nodes) * (choice.startSeconds + inBlock);
    choice.samplesSeconds = std::max(bySamples, link);
    const std::string work = shortTime(choice.workSeconds), start = shortTime(choice.startSeconds);
    if (choice.workSeconds >= choice.startSeconds)
        return tilesSince(choice, "a tile keeps a node busy for longer than it needs to start: " + work + ", " + start);
    if (link >= byTiles)
        return tilesSince(choice, "the network takes longest either way: " + shortTime(link));
    if (choice.samplesSeconds >= choice.tilesSeconds)
        return tilesSince(choice, "there are too few blocks of 64 samples for all nodes: they would take " +
                                      shortTime(choice.samplesSeconds) + ", tiles take " +
                                      shortTime(choice.tilesSeconds));
    choice.split = Split::samples;
    choice.reason = "tiles would be smaller than what a node needs to start: " + work + " of " + start;
    return choice;
}

}  // namespace pdr
