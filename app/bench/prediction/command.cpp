#include <cmath>
#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/prediction/coverage.h"
#include "app/bench/prediction/scenes.h"

namespace pdr::bench {

namespace {

constexpr float kExposure = 0.5f;

/// Over all rows that did not say "at least".
struct Total {
    int seeds = 0, within = 0;
};

void printRow(const std::string& name, const Prediction& asked, const PredictionTally& tally, Total& total) {
    const bool least = tally.atLeast > tally.seeds / 2;
    std::printf("%-24s %7d %10.2f %13.2f %7.1f %% %9.1f %% %6d\n", name.c_str(), int(asked.samples), asked.part,
                median(tally.ratios), 100.0 * tally.within / tally.seeds, 100.0 * tally.notBefore / tally.seeds,
                tally.atLeast);
    std::fflush(stdout);
    if (least)
        return;
    total.seeds += tally.seeds;
    total.within += tally.within;
}

Result<std::vector<NamedScene>> scenesOf(const std::vector<std::string>& files) {
    std::vector<NamedScene> scenes;
    for (const std::string& file : files) {
        const Result<Scene> scene = loadScene(file);
        if (!scene)
            return scene.error();
        scenes.push_back({file, *scene});
    }
    return files.empty() ? predictionScenes() : scenes;
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
    const auto device = makeCpuDevice(*threads);
    std::printf("%d seeds, %d x %d pixels; samples foretold over needed, and how often the 95 %% interval held\n\n",
                *seeds, *width, *height);
    std::printf("%-24s %7s %10s %13s %9s %11s %6s\n", "scene", "from", "to error x", "median", "coverage", "not before",
                "least");
    Total total;
    for (NamedScene& named : *scenes) {
        named.scene.film = {*width, *height};
        for (const std::uint64_t samples : {64, 256})
            for (const double part : {0.6, 0.35}) {
                const Prediction asked{samples, part};
                const auto tally = tallyOf(named.scene, asked, *seeds, kExposure, *device);
                if (!tally)
                    return fail(tally.error());
                printRow(named.name, asked, *tally, total);
            }
    }
    if (total.seeds > 0)
        std::printf("\nall that did not say \"at least\": %.1f %% of %d inside\n", 100.0 * total.within / total.seeds,
                    total.seeds);
    return 0;
}

}  // namespace pdr::bench
