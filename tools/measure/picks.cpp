/// Measures what clicks on images of a scan find (render/prepare/layers_under.h), for each shipped look, and what a
/// click costs.
///   picks FOLDER [--looks A,B,...] [--size N]
/// FOLDER holds a CT, or is a scene file; images are N pixels wide, and the clicks lie on a grid. Prints a line for
/// each look, of the clicks under which a quarter of the light or more meets tissue: how many find a place, a choice
/// and neither, how many of the places lie on a silhouette, the standard deviation of the others along the ray (median
/// and 90 %), and the processor time of a click (median, 95 % and the longest), without the preparation of the scene,
/// whose time comes last.

#include <QCoreApplication>
#include <algorithm>
#include <cstdio>
#include <map>

#include "app/bench/options.h"
#include "app/cli/scene/scene_input.h"
#include "app/looks/looks.h"
#include "render/base/processor_time.h"
#include "render/prepare/flatten.h"
#include "render/prepare/layers_under.h"

namespace pdr::test {
namespace {

double quantile(std::vector<double> values, double part) {
    if (values.empty())
        return 0;
    std::ranges::sort(values);
    return values[std::size_t(part * double(values.size() - 1))];
}

/// What the clicks on all pixels of one image have found.
struct Clicks {
    std::map<SeenAt, int> seen;
    int tissue = 0, silhouettes = 0;
    std::vector<double> sigmaMm;
    std::vector<double> microseconds;

    void add(const LayersUnder& under, double seconds) {
        if (under.met < 0.25)
            return;
        ++tissue;
        ++seen[under.seen];
        microseconds.push_back(1e6 * seconds);
        if (under.seen != SeenAt::place)
            return;
        if (under.layers[0].onSilhouette)
            ++silhouettes;
        else
            sigmaMm.push_back(under.layers[0].sigmaAlongMm);
    }
};

Clicks clicksOn(const PreparedScene& scene) {
    Clicks clicks;
    const ivec2 film = scene.flat.camera.film;
    const int step = std::max(film.x / 80, 1);
    for (int y = step / 2; y < film.y; y += step)
        for (int x = step / 2; x < film.x; x += step) {
            const double start = processorSeconds();
            const LayersUnder under = layersUnder(scene, vec2(x, y) + 0.5f);
            clicks.add(under, processorSeconds() - start);
        }
    return clicks;
}

void measure(const std::string& folder, const NamedLook& look, int size) {
    const auto loaded = app::loadScene({.path = folder, .look = look, .size = ivec2(size)}, noProgress);
    if (!loaded) {
        std::fprintf(stderr, "%s: %s\n", look.name.c_str(), loaded.error().what.c_str());
        return;
    }
    const double start = processorSeconds();
    const auto prepared = Flattener().prepare(loaded->scene);
    const double preparing = processorSeconds() - start;
    Clicks clicks = clicksOn(*prepared);
    const auto part = [](int count, int of) { return of > 0 ? 100.0 * count / of : 0; };
    const int places = clicks.seen[SeenAt::place], choices = clicks.seen[SeenAt::choice];
    std::printf("%-28s %6.1f %6.1f %6.1f %6.1f | %5.2f %5.2f | %5.0f %5.0f %5.0f | %5.0f\n", look.name.c_str(),
                part(places, clicks.tissue), part(choices, clicks.tissue),
                part(clicks.tissue - places - choices, clicks.tissue), part(clicks.silhouettes, places),
                quantile(clicks.sigmaMm, 0.5), quantile(clicks.sigmaMm, 0.9), quantile(clicks.microseconds, 0.5),
                quantile(clicks.microseconds, 0.95), quantile(clicks.microseconds, 1), 1e3 * preparing);
    std::fflush(stdout);
}

}  // namespace
}  // namespace pdr::test

int main(int count, char** words) {
    using namespace pdr;
    QCoreApplication application(count, words);
    const auto options = bench::Options::read({words + 1, words + count}, {"--looks", "--size"});
    const auto size = options ? options->number("--size", 640, 16) : std::nullopt;
    const auto looks = app::bundledLooks();
    if (!size || !looks || options->files.size() != 1) {
        std::fprintf(stderr, "usage: picks FOLDER [--looks A,B,...] [--size N]\n");
        return 2;
    }
    std::printf("%-28s %6s %6s %6s %6s | %11s | %17s | %5s\n", "look", "place%", "choice", "none", "edge%", "sigma mm",
                "us a click", "ms");
    const std::string names = options->word("--looks", "");
    for (const NamedLook& look : *looks)
        if (names.empty() || ("," + names + ",").find("," + look.name + ",") != std::string::npos)
            test::measure(options->files[0], look, *size);
    return 0;
}
