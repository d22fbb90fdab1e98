#include "app/cli/render/replay_command.h"

#include <cstdio>

#include "app/cli/render/render_options.h"
#include "app/cli/run_command.h"
#include "render/device/cpu/replay.h"
#include "render/film/health_text.h"
#include "render/prepare/flatten.h"
#include "render/scene/scene.h"

namespace pdr::app {
namespace {

template <class Vector>
void printTriple(const char* what, const Vector& v) {
    std::printf("%s(%.6g, %.6g, %.6g)", what, double(v.x), double(v.y), double(v.z));
}

void printCollected(const ReplayedSegment& segment) {
    if (segment.collected == vec3(0))
        return;
    printTriple("    meets lights, which bring ", segment.collected);
    std::printf("\n");
}

void printLight(const ReplayedLight& light) {
    if (light.radiance == vec3(0)) {
        std::printf("    no light reaches it\n");
        return;
    }
    printTriple("    light from ", light.direction);
    if (light.distance < 1e29f)
        std::printf(", %.6g mm away", double(light.distance));
    printTriple(", brings ", light.radiance);
    std::printf(" times a transmittance of %.6g\n", double(light.transmittance));
}

void printEvent(const ReplayedEvent& event) {
    if (event.collision < 0) {
        std::printf("  through to the end: no event\n");
        return;
    }
    const bool surface = event.event.normal != vec3(0);
    std::printf("  event after %.6g mm\n", double(event.collision));
    printTriple("    at ", event.placeMm);
    std::printf(" mm: %.6g HU, extinction %.6g per mm, %s\n", double(event.hu), double(event.extinction),
                surface ? "a surface reflects" : "the phase function scatters");
    printTriple("    albedo ", event.event.material.albedo);
    if (surface)
        printTriple(", normal ", event.event.normal);
    if (event.emitted != vec3(0))
        printTriple(", glow ", event.emitted);
    std::printf("\n");
    printLight(event.light);
}

void printSegment(int number, const ReplayedSegment& segment) {
    std::printf("%d ", number);
    printTriple("from ", segment.startMm);
    printTriple(" mm towards ", segment.direction);
    std::printf(segment.length > 0 ? "\n" : ": nothing in its way\n");
    printCollected(segment);
    if (segment.length > 0)
        for (const ReplayedEvent& event : segment.events)
            printEvent(event);
    if (segment.events.back().collision >= 0) {
        printTriple("    the path goes on with ", segment.throughput);
        std::printf("\n");
    }
}

Result<void> tell(const ReplayOptions& options) {
    // Load the scene and check that the sample can be replayed
    auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    const Scene& scene = loaded->scene;
    if (isProjection(scene.model))
        return Error{std::string(modelName(scene.model)) + " has no paths to replay", "--model",
                     "Take singleScattering or multipleScattering."};
    if (scene.estimator != Estimator::unbiased)
        return Error{"the samples of " + std::string(estimatorName(scene.estimator)) + " cannot be replayed",
                     "--estimator", "Take the estimator unbiased."};
    if (options.pixel.x >= scene.film.x || options.pixel.y >= scene.film.y)
        return Error{"lies outside the image of " + std::to_string(scene.film.x) + " x " +
                         std::to_string(scene.film.y) + " pixels",
                     "--pixel", ""};
    // Replay the sample and print its path
    const Replay replay = replayed(*Flattener().prepare(scene), options.pixel, options.sample);
    std::printf("pixel %d,%d sample %llu seed %llu, %s\n", options.pixel.x, options.pixel.y,
                static_cast<unsigned long long>(options.sample), static_cast<unsigned long long>(scene.seed),
                modelName(scene.model));
    for (std::size_t i = 0; i < replay.segments.size(); ++i)
        printSegment(int(i), replay.segments[i]);
    printTriple("radiance ", replay.radiance);
    std::printf("\n");
    for (const Text& fault : healthLines(replay.faults))
        std::printf("%s\n", fault.c_str());
    return {};
}

}  // namespace

int runReplay(const QStringList& arguments) {
    return runCommand("replay", replayOptions(arguments), replayHelp, [](const ReplayOptions& options) {
        const auto done = tell(options);
        return done ? 0 : failed(done.error());
    });
}

}  // namespace pdr::app
