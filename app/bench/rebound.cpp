#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <random>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "render/device/device_list.h"
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

/// One core of the host: from the curve to its bounds.
double hostMilliseconds(const CellRanges& ranges, ivec3 size, const TransferFunction& function) {
    const std::clock_t start = std::clock();  // time on the core: neighbours do not count
    const Majorants majorants(ranges, TransferTables(function), size);
    return 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A device with a memory of its own: from the edited scene to the device being ready to render it.
double deviceMilliseconds(Device& device, Flattener& flattener, const Scene& scene) {
    const auto prepared = flattener.prepare(scene, boundsFor(device.info()));
    const auto start = std::chrono::steady_clock::now();
    const auto uploaded = device.upload(prepared);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return uploaded ? 1e3 * seconds : -1;
}

}  // namespace

int rebound(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--size", "--edits", "--device"});
    const auto size = options ? options->number("--size", 256, 2) : std::nullopt;
    const auto edits = options ? options->number("--edits", 21, 1) : std::nullopt;
    if (!size || !edits || !options->files.empty())
        return 2;
    const auto device = openDevice(options->word("--device", "cpu"));
    if (!device)
        return fail(device.error());
    const bool onHost = (*device)->info().hostMemory;
    const tbb::global_control oneCore(tbb::global_control::max_allowed_parallelism,
                                      onHost ? 1 : tbb::this_task_arena::max_concurrency());
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom(ivec3(*size), dvec3(250.0 / *size), 1));
    scene.film = {60, 34};
    std::optional<CellRanges> ranges;
    if (onHost)
        ranges.emplace(*scene.volume);
    Flattener flattener;
    std::mt19937 random(1);
    std::vector<double> milliseconds;
    for (int i = 0; i <= *edits; ++i) {
        scene.transferFunction = editedFunction(random);
        const double took = onHost ? hostMilliseconds(*ranges, scene.volume->size(), scene.transferFunction)
                                   : deviceMilliseconds(**device, flattener, scene);
        if (took < 0)
            return fail({"the scene could not be sent to the device", options->word("--device", ""), ""});
        if (i > 0)  // the first one brings the volume
            milliseconds.push_back(took);
    }
    std::ranges::sort(milliseconds);
    std::printf("{\"size\": %d, \"edits\": %d, \"medianMs\": %.4f, \"slowestMs\": %.4f}\n", *size, *edits,
                milliseconds[milliseconds.size() / 2], milliseconds.back());
    return 0;
}

}  // namespace pdr::bench
