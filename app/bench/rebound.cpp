#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <random>
#include <vector>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "render/device/device_list.h"
#include "render/prepare/flatten.h"
#include "render/scene/scene.h"
#include "render/volume/phantom.h"

namespace pdr::bench {

namespace {

/// Returns a curve as a user may draw it: a few nodes at random places, with bands and steps.
TransferFunction editedFunction(std::mt19937& random) {
    std::uniform_real_distribution<float> hu(-1000, 2000), opacity(0, 1);
    TransferFunction function;
    for (int i = 0; i < 8; ++i)
        function.nodes.push_back({.hu = hu(random), .opacity = i % 3 ? opacity(random) : 0});
    std::ranges::sort(function.nodes, {}, &TransferNode::hu);
    return function;
}

double wallMilliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Successive edits of the transfer function of one scene.
struct Edits {
    Scene scene;
    std::mt19937 random{1};

    const Scene& next() {
        scene.transferFunction = editedFunction(random);
        ++scene.revision;
        return scene;
    }
};

using Milliseconds = Result<std::vector<double>>;

/// Measures the time from the curve to its majorants on one core of the host.
Milliseconds boundsOnHost(Edits edits, int count) {
    const tbb::global_control oneCore(tbb::global_control::max_allowed_parallelism, 1);
    const CellRanges ranges(*edits.scene.volume);
    std::vector<double> took;
    for (int i = 0; i < count; ++i) {
        const Scene& scene = edits.next();
        const std::clock_t start = std::clock();  // time on the core, which excludes other programs
        const Majorants majorants(ranges, TransferTables(scene.transferFunction), scene.volume->size());
        took.push_back(1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return took;
}

/// Measures the time from the edited scene until a device with its own memory is ready to render it.
Milliseconds boundsOnDevice(Edits edits, int count, Device& device) {
    std::vector<double> took;
    for (int i = 0; i <= count; ++i) {
        const Scene& scene = edits.next();
        const double start = wallMilliseconds();
        if (const auto uploaded = device.upload(scene); !uploaded)
            return uploaded.error();
        if (i > 0)  // the first upload includes the volume
            took.push_back(wallMilliseconds() - start);
    }
    return took;
}

/// Measures the time from the edited scene to its first image of one sample, in the film of the scene before it.
Milliseconds images(Edits edits, int count, Device& device) {
    auto film = startFilm(device, edits.next());
    if (!film)
        return film.error();
    std::vector<double> took;
    for (int i = 0; i <= count; ++i) {
        const Scene& scene = edits.next();
        const double start = wallMilliseconds();
        Result<void> done = device.upload(scene);
        done = done ? (*film)->restart((*film)->area(), scene.revision) : done;
        done = done ? (*film)->accumulate(1, {}) : done;
        done = done ? (*film)->resolve({}) : done;
        if (!done)
            return done.error();
        if (const auto image = (*film)->readback(); !image)
            return image.error();
        if (i > 0)
            took.push_back(wallMilliseconds() - start);
    }
    return took;
}

}  // namespace

int rebound(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--size", "--edits", "--device", "--width", "--height"});
    const auto size = options ? options->number("--size", 256, 2) : std::nullopt;
    const auto edits = options ? options->number("--edits", 21, 1) : std::nullopt;
    const auto width = options ? options->number("--width", 1920, 1) : std::nullopt;
    const auto height = options ? options->number("--height", 1080, 1) : std::nullopt;
    if (!size || !edits || !width || !height || !options->files.empty())
        return 2;
    const auto device = openDevice(options->word("--device", "cpu"));
    if (!device)
        return fail(device.error());
    // Make a head that is seen from the front
    Edits first;
    first.scene.volume = std::make_shared<Volume>(headPhantom(ivec3(*size), dvec3(250.0 / *size), 1));
    const VolumeGeometry& head = first.scene.volume->geometry();
    first.scene.camera =
        standardView(StandardView::anterior, head.centreMm(), head.radiusMm(), double(*width) / *height);
    first.scene.environment = {vec3(1), false};
    first.scene.film = {*width, *height};
    // Measure the majorants, then the images
    const bool onHost = (*device)->info().hostMemory;
    const Milliseconds bounds = onHost ? boundsOnHost(first, *edits) : boundsOnDevice(first, *edits, **device);
    const Milliseconds shown = bounds ? images(first, *edits, **device) : bounds;
    if (!shown)
        return fail(shown.error());
    std::printf(
        "{\"size\": %d, \"edits\": %d, \"medianMs\": %.4f, \"slowestMs\": %.4f, \"width\": %d, \"height\": %d, "
        "\"imageMs\": %.2f}\n",
        *size, *edits, median(*bounds), *std::ranges::max_element(*bounds), *width, *height, median(*shown));
    return 0;
}

}  // namespace pdr::bench
