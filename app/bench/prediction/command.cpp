#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/prediction/coverage.h"
#include "app/bench/prediction/scenes.h"
#include "app/bench/prediction/stated_error.h"

namespace pdr::bench {

namespace {

constexpr Prediction kAsked[] = {{64, 0.7}, {64, 0.5}, {64, 0.35}, {256, 0.7}, {256, 0.5}, {256, 0.35}};
constexpr std::uint32_t kTruth = 16'384;  ///< samples per pixel of the reference for stated errors

/// Totals over all rows, except those in which most forecasts are only lower bounds ("at least").
struct Total {
    int seeds = 0, within = 0;
    std::vector<double> ratios;

    void add(const PredictionTally& tally) {
        seeds += tally.seeds;
        within += tally.within;
        ratios.insert(ratios.end(), tally.ratios.begin(), tally.ratios.end());
    }
};

Result<std::vector<PredictionScene>> scenesOf(const std::vector<std::string>& files) {
    std::vector<PredictionScene> scenes;
    for (const std::string& file : files) {
        const Result<Scene> scene = loadScene(file);
        if (!scene)
            return scene.error();
        scenes.push_back({file, *scene});
    }
    return files.empty() ? predictionScenes() : scenes;
}

Result<void> printStated(const PredictionScene& named, int seeds, Device& device) {
    const auto errors = statedErrors(named.scene, {64, 256, 1024}, seeds, kTruth, named.exposure, device);
    if (!errors)
        return errors.error();
    for (const StatedError& error : *errors)
        std::printf("%-20s %7d %15.1f %% %19d\n", named.name.c_str(), int(error.samples), 100 * error.within,
                    error.fewBright);
    std::fflush(stdout);
    return {};
}

Result<void> printForetold(const PredictionScene& named, int seeds, Device& device, Total& total) {
    const auto tallies = talliesOf(named.scene, kAsked, seeds, named.exposure, device);
    if (!tallies)
        return tallies.error();
    for (std::size_t i = 0; i < tallies->size(); ++i) {
        const PredictionTally& tally = (*tallies)[i];
        std::printf("%-20s %7d %10.2f %13.2f %7.1f %% %9.1f %% %8d\n", named.name.c_str(), int(kAsked[i].samples),
                    kAsked[i].part, median(tally.ratios), 100.0 * tally.within / tally.seeds,
                    100.0 * tally.notBefore / tally.seeds, tally.atLeast);
        if (tally.atLeast <= tally.seeds / 2)
            total.add(tally);
    }
    std::fflush(stdout);
    return {};
}

}  // namespace

int prediction(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--seeds", "--threads", "--width", "--height"});
    const auto seeds = options ? options->number("--seeds", 40, 2) : std::nullopt;
    const auto threads = options ? options->number("--threads", 0, 0) : std::nullopt;
    const auto width = options ? options->number("--width", 28, 8) : std::nullopt;
    const auto height = options ? options->number("--height", 22, 8) : std::nullopt;
    if (!seeds || !threads || !width || !height)
        return 2;
    auto scenes = scenesOf(options->files);
    if (!scenes)
        return fail(scenes.error());
    for (PredictionScene& named : *scenes)
        named.scene.film = {*width, *height};
    const auto device = makeCpuDevice(*threads);
    // Measure how much of the tissue lies within the stated error
    std::printf("%d seeds, %d x %d pixels\n\nThe tissue within what is stated for 95 %% of it, on the mean\n", *seeds,
                *width, *height);
    std::printf("%-20s %7s %17s %19s\n", "scene", "samples", "within", "few bright samples");
    for (const PredictionScene& named : *scenes)
        if (const auto ok = printStated(named, *seeds, *device); !ok)
            return fail(ok.error());
    // Measure how often forecasts come true
    std::printf("\nSamples foretold over needed, and how often the 95 %% interval held\n");
    std::printf("%-20s %7s %10s %13s %9s %11s %8s\n", "scene", "from", "to error x", "median", "coverage", "not before",
                "at least");
    Total total;
    for (const PredictionScene& named : *scenes)
        if (const auto ok = printForetold(named, *seeds, *device, total); !ok)
            return fail(ok.error());
    if (total.seeds > 0)
        std::printf("\nof all that did not say \"at least\": median %.2f, %.1f %% of %d inside\n", median(total.ratios),
                    100.0 * total.within / total.seeds, total.seeds);
    return 0;
}

}  // namespace pdr::bench
