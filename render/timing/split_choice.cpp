#include "render/timing/split_choice.h"

#include <algorithm>
#include <cmath>

#include "render/base/tile.h"

namespace pdr {

namespace {

/// Returns a time with two significant digits: "0.8 ms", "120 ms", "12 s".
Text shortTime(double seconds) {
    const bool large = seconds >= 1;
    const double value = large ? seconds : 1e3 * seconds;
    const double unit = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 1) : 1;
    const Text number = numberOf(std::round(value / unit) * unit);
    return large ? phrase("%1 s", number) : phrase("%1 ms", number);
}

SplitChoice tilesSince(SplitChoice choice, Text reason) {
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
    // Predict the time by tiles, then by samples
    const double byTiles =
        blocks * choice.startSeconds + double(facts.samples) * facts.sampleSeconds * facts.pixels / nodes;
    choice.tilesSeconds = choice.samplesSeconds = std::max(byTiles, link);
    if (nodes < 2)
        return tilesSince(choice, phrase("one render node has the whole image"));
    if (facts.samples < 2 * kSamplesPerBlock)
        return tilesSince(choice, phrase("samples are shared out in blocks of 64, and fewer than two are ordered"));
    const double bySamples = std::ceil(blocks / nodes) * (choice.startSeconds + inBlock);
    choice.samplesSeconds = std::max(bySamples, link);
    // Choose, with the reason
    const Text work = shortTime(choice.workSeconds), start = shortTime(choice.startSeconds);
    if (choice.workSeconds >= choice.startSeconds)
        return tilesSince(
            choice, phrase("a tile keeps a render node busy for longer than it needs to start: %1, %2", work, start));
    if (link >= byTiles)
        return tilesSince(choice, phrase("the network takes longest either way: %1", shortTime(link)));
    if (choice.samplesSeconds >= choice.tilesSeconds)
        return tilesSince(
            choice,
            phrase("there are too few blocks of 64 samples for all render nodes: they would take %1, tiles take %2",
                   shortTime(choice.samplesSeconds), shortTime(choice.tilesSeconds)));
    choice.split = Split::samples;
    choice.reason = phrase("tiles would be smaller than what a render node needs to start: %1 of %2", work, start);
    return choice;
}

}  // namespace pdr
