#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/bench/commands.h"
#include "app/bench/filtering/price.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "render/device/device_list.h"
#include "render/device/emulated/emulated_gpu.h"
#include "render/kernel/texture.h"
#include "render/prepare/flatten.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

struct Price {
    DeviceInfo device;
    bool onGpu;
    int samples, rounds;
    HuPrice hu;
    ImagePrice image;
};

void printText(const Price& price) {
    const auto& [hu, levels] = std::pair(price.hu, price.image.levels);
    std::printf("exact and fast filtering on %s (%s)\n\n", price.device.name.c_str(), price.device.details.c_str());
    std::printf("HU, at %d places (fast filtering as the CUDA guide describes it)\n", hu.places);
    std::printf("  difference       rms %.3g, 99.9 %% below %.3g, largest %.3g, possible %.3g\n\n", hu.rms,
                hu.almostAll, hu.largest, hu.possible);
    std::printf("display levels, of 255, %d samples a pixel, %zu pixels that have noise\n", price.samples,
                levels.pixels);
    std::printf("  difference       mean %.3g, largest %.3g, shift %+.3g, more than 1 level: %.3g %% of the pixels\n",
                levels.mean, levels.largest, levels.shift, 100 * levels.offByOne);
    std::printf("  standard error   mean %.3g\n\n", levels.standardError);
    std::printf("time, medians of %d runs in turns\n", price.rounds);
    std::printf("  exact %.4g s, fast %.4g s: fast takes %.3f of the time\n", price.image.exactSeconds,
                price.image.fastSeconds, price.image.fastSeconds / price.image.exactSeconds);
    if (!price.onGpu)
        std::puts("  This is a GPU emulated on the CPU: what time is saved can only be measured on a GPU.");
}

void printJson(const Price& price) {
    const HuPrice& hu = price.hu;
    const LevelPrice& levels = price.image.levels;
    const nlohmann::ordered_json json{{"device", price.device.name},
                                      {"onGpu", price.onGpu},
                                      {"hu",
                                       {{"places", hu.places},
                                        {"rms", hu.rms},
                                        {"below999", hu.almostAll},
                                        {"largest", hu.largest},
                                        {"possible", hu.possible}}},
                                      {"levels",
                                       {{"samples", price.samples},
                                        {"pixels", levels.pixels},
                                        {"mean", levels.mean},
                                        {"largest", levels.largest},
                                        {"shift", levels.shift},
                                        {"offByMoreThanOne", levels.offByOne},
                                        {"standardError", levels.standardError}}},
                                      {"time",
                                       {{"rounds", price.rounds},
                                        {"exactSeconds", price.image.exactSeconds},
                                        {"fastSeconds", price.image.fastSeconds},
                                        {"fastOverExact", price.image.fastSeconds / price.image.exactSeconds}}}};
    std::puts(json.dump().c_str());
}

/// Returns an error if the images of the scene do not depend on its filtering.
Result<void> hasChoice(const Scene& scene) {
    if (isProjection(scene.model))
        return Error{"the model " + std::string(modelName(scene.model)) + " is always filtered exactly", "model",
                     "Take singleScattering or multipleScattering."};
    if (!textureHolds(scene.volume->storedRange()))
        return Error{"the volume holds -32768 HU, which textures do not know: it is always filtered exactly", "volume",
                     "Clamp it in the scene file, with \"clampHu\"."};
    return {};
}

}  // namespace

int filtering(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--device", "--samples", "--points", "--rounds"}, {"--json"});
    const auto samples = options ? options->number("--samples", 64, 2) : std::nullopt;
    const auto points = options ? options->number("--points", 1'000'000, 1) : std::nullopt;
    const auto rounds = options ? options->number("--rounds", 3, 1) : std::nullopt;
    if (!samples || !points || !rounds || options->files.size() != 1)
        return 2;
    const Result<Scene> scene = loadScene(options->files[0]);
    if (!scene)
        return fail(scene.error());
    if (const auto choice = hasChoice(*scene); !choice)
        return fail(choice.error());
    const auto named = options->named.find("--device");
    Result<std::unique_ptr<Device>> device = openDevice(named == options->named.end() ? "cpu" : named->second);
    if (!device)
        return fail(device.error());
    const bool onGpu = !(*device)->info().hostMemory;
    if (!onGpu)
        device = makeEmulatedGpu();

    // Measure the differences in HU and in display levels, and the times
    const auto prepared = Flattener().flatten(*scene);
    const HuPrice hu = huPrice(prepared->flat.volume, *points, scene->seed);
    const auto image = imagePrice(**device, *scene, std::uint32_t(*samples), *rounds);
    if (!image)
        return fail(image.error());
    const Price price{(*device)->info(), onGpu, *samples, *rounds, hu, *image};
    options->named.contains("--json") ? printJson(price) : printText(price);
    return 0;
}

}  // namespace pdr::bench
