#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>

#include "app/bench/commands.h"
#include "app/bench/options.h"
#include "render/scene/flatten.h"
#include "render/volume/phantom.h"

namespace pdr::bench {

namespace {

/// A curve as a hand drags it: a few nodes at random places, bands and steps included.
TransferFunction editedFunction(std::mt19937& random) {
    std::uniform_real_distribution<float> hu(-1000, 2000), opacity(0, 1);
    TransferFunction function;
    for (int i = 0; i < 8; ++i)
        function.nodes.push_back({.hu = hu(random), .opacity = i % 3 ? opacity(random) : 0});
    std::ranges::sort(function.nodes, {}, &TransferNode::hu);
    return function;
}

}  // namespace

int rebound(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--size", "--edits"});
    const auto size = options ? options->number("--size", 256, 2) : std::nullopt;
    const auto edits = options ? options->number("--edits", 21, 1) : std::nullopt;
    if (!size || !edits || !options->files.empty())
        return 2;
    const tbb::global_control oneCore(tbb::global_control::max_allowed_parallelism, 1);
    const Volume volume = headPhantom(ivec3(*size), dvec3(250.0 / *size), 1);
    const CellRanges ranges(volume);
    std::mt19937 random(1);
    std::vector<double> milliseconds;
    for (int i = 0; i < *edits; ++i) {
        const TransferFunction function = editedFunction(random);
        const std::clock_t start = std::clock();  // time on the core: neighbours do not count
        const Majorants majorants(ranges, TransferTables(function), volume.size());
        milliseconds.push_back(1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::ranges::sort(milliseconds);
    std::printf("{\"size\": %d, \"edits\": %d, \"medianMs\": %.3f, \"slowestMs\": %.3f}\n", *size, *edits,
                milliseconds[milliseconds.size() / 2], milliseconds.back());
    return 0;
}

}  // namespace pdr::bench
