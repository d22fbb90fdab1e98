#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "render/base/processor_time.h"
#include "render/smooth/noise_level.h"
#include "render/smooth/non_local_means.h"
#include "render/volume/phantom.h"

namespace pdr::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kHeadMm = 250;  ///< edge of the head's slices

/// Times to denoise 100 slices [s].
struct Times {
    std::vector<double> processor, clock;
};

Result<std::shared_ptr<const Volume>> scanOf(const Options& options, int slices) {
    if (options.files.empty())
        return std::make_shared<const Volume>(headPhantom({512, 512, slices}, dvec3(kHeadMm / 512)));
    auto scene = loadScene(options.files.front());
    if (!scene)
        return scene.error();
    return scene->volume;
}

}  // namespace

int ctNoise(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--slices", "--rounds"});
    const auto slices = options ? options->number("--slices", 100, 1) : std::nullopt;
    const auto rounds = options ? options->number("--rounds", 5, 1) : std::nullopt;
    if (!slices || !rounds || options->files.size() > 1)
        return 2;
    const auto scan = scanOf(*options, *slices);
    if (!scan)
        return fail(scan.error());
    const Volume& volume = **scan;
    const double per100 = 100.0 / volume.size().z;
    Times times;
    double left = 0;
    for (int round = 0; round < *rounds; ++round) {
        const double start = processorSeconds();
        const Clock::time_point begun = Clock::now();
        const auto denoised = ctDenoised(volume, noProgress);
        if (!denoised)
            return fail(denoised.error());
        times.clock.push_back(per100 * std::chrono::duration<double>(Clock::now() - begun).count());
        times.processor.push_back(per100 * (processorSeconds() - start));
        left = noiseOf(*denoised);
    }
    std::printf(
        "{\"width\": %d, \"height\": %d, \"slices\": %d, \"noiseHu\": %.1f, \"noiseLeftHu\": %.1f, "
        "\"processorSecondsPer100Slices\": %.3f, \"secondsPer100Slices\": %.3f}\n",
        volume.size().x, volume.size().y, volume.size().z, noiseOf(volume), left, median(times.processor),
        median(times.clock));
    return 0;
}

}  // namespace pdr::bench
