#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "render/device/emulated/host_gpu.h"
#include "render/device/gpu_device.h"

namespace pdr::bench {

namespace {

constexpr bool kNoHostMemory = false;

void print(const std::string& kernel, const WarpCounts& counts, double samples) {
    const auto share = [](std::uint64_t walks, std::uint64_t warps) {
        return warps > 0 ? double(walks) / double(warps) : 0;
    };
    std::printf("%-8s %12.3f %12.3f %13.1f %13.3f %12.3f %12.1f\n", kernel.c_str(), double(counts.started) / samples,
                double(counts.starts) / samples, share(counts.started, counts.starts), double(counts.stepped) / samples,
                double(counts.steps) / samples, share(counts.stepped, counts.steps));
}

}  // namespace

int warps(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--samples", "--width", "--height"});
    const auto number = [&](const char* name, int otherwise) {
        return options ? options->number(name, otherwise, 1) : std::nullopt;
    };
    const auto samples = number("--samples", 1), width = number("--width", 480), height = number("--height", 270);
    if (!samples || !width || !height || options->files.size() != 1)
        return 2;
    Result<Scene> scene = loadScene(options->files[0]);
    if (!scene)
        return fail(scene.error());
    scene->film = {*width, *height};
    constexpr std::size_t kAllMemory = 0;
    GpuDevice<HostGpu> device({"lockstep", "warps in step", kNoHostMemory}, kAllMemory, 0, HostGpu::Walks::inWarps);
    if (const Result<void> uploaded = device.upload(*scene); !uploaded)
        return fail(uploaded.error());
    const auto film = device.film(wholeImage(scene->film), scene->revision, {});
    if (!film)
        return fail(film.error());
    if (const Result<void> done = (*film)->accumulate(std::uint32_t(*samples), {}); !done)
        return fail(done.error());
    const double all = double(*samples) * scene->film.x * scene->film.y;
    std::printf("per sample of %d x %d pixels; of %d lanes each\n", scene->film.x, scene->film.y, kWarp);
    std::printf("%-8s %12s %12s %13s %13s %12s %12s\n", "kernel", "walks", "warp starts", "lanes a start", "steps",
                "warp steps", "lanes a step");
    for (const auto& [kernel, counts] : device.gpu().warpCounts())
        print(kernel, counts, all);
    return 0;
}

}  // namespace pdr::bench
