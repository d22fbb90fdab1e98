#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

/// Writes linear radiance as a little-endian colour PFM, bottom row first.
bool writeColours(const Film& film, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << "PF\n" << film.size().x << ' ' << film.size().y << "\n-1\n";
    for (int y = film.size().y - 1; y >= 0; --y)
        for (int x = 0; x < film.size().x; ++x) {
            const vec3 radiance(film.pixel(x, y).mean);
            file.write(reinterpret_cast<const char*>(&radiance), sizeof radiance);
        }
    return bool(file.flush());
}

}  // namespace

int frames(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--frames", "--threads", "--colours"});
    const auto count = options ? options->number("--frames", 15, 1) : std::nullopt;
    const auto threads = options ? options->number("--threads", 0, 0) : std::nullopt;
    if (!count || !threads || options->files.size() != 1)
        return 2;
    const Result<Scene> scene = loadScene(options->files[0]);
    if (!scene)
        return fail(scene.error());
    const std::unique_ptr<Device> device = makeCpuDevice(*threads);
    const auto live = startFilm(*device, *scene);
    if (!live)
        return fail(live.error());
    std::vector<double> wall, cpu;
    for (int frame = 0; frame < *count; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t onCores = std::clock();
        if (const auto accumulated = (*live)->accumulate(1, {}); !accumulated)
            return fail(accumulated.error());
        wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        cpu.push_back(1e3 * double(std::clock() - onCores) / CLOCKS_PER_SEC);
    }
    std::printf("{\"frames\": %d, \"medianMs\": %.2f, \"medianCpuMs\": %.2f, \"fastestMs\": %.2f}\n", *count,
                median(wall), median(cpu), *std::ranges::min_element(wall));
    if (const auto colours = options->named.find("--colours"); colours != options->named.end())
        if (const auto film = (*live)->film(); !film || !writeColours(**film, colours->second))
            return fail({"the image cannot be written", colours->second, ""});
    return 0;
}

}  // namespace pdr::bench
