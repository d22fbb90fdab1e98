#pragma once
/// Small scenes with known answers.

#include <algorithm>
#include <random>
#include <vector>

#include "render/device/cpu/cpu_tracer.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/prepare/flatten.h"
#include "render/scene/scene.h"
#include "tests/support/devices/tested_device.h"

namespace pdr::test {

/// Makes a volume whose voxels are value(i, j, k), `spacing` mm apart, with a corner of the box at the origin.
template <class Value>
std::shared_ptr<const Volume> makeVolume(ivec3 size, dvec3 spacing, Value&& value) {
    Voxels voxels;
    voxels.reserve(std::size_t(size.x) * size.y * size.z);
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                voxels.push_back(std::int16_t(value(i, j, k)));
    return std::make_shared<Volume>(VolumeGeometry::aligned(size, spacing, spacing * 0.5), std::move(voxels));
}

/// Makes rough tissue: smooth blobs with noise, HU -1000 .. 2000.
inline std::shared_ptr<const Volume> bumpyVolume(ivec3 size, dvec3 spacing, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-150, 150);
    return makeVolume(size, spacing, [&](int i, int j, int k) {
        const double wave = std::sin(0.31 * i) + std::sin(0.23 * j + 1) + std::sin(0.37 * k + 2);
        return std::clamp(500 * wave + noise(random), -1000.0, 2000.0);
    });
}

/// Makes a scene with constant extinction in all of `volume`, white, lit from above.
inline Scene plainScene(std::shared_ptr<const Volume> volume, float extinctionPerMm) {
    Scene scene;
    scene.volume = std::move(volume);
    scene.transferFunction.extinctionPerMm = extinctionPerMm;
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 1, .albedo = vec3(1)}};
    scene.lights = {DirectionalLight{{0, 0, -1}, vec3(1)}};
    const VolumeGeometry& geometry = scene.volume->geometry();
    scene.camera = standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), 1);
    scene.film = {32, 32};
    return scene;
}

/// Renders `samples` per pixel of a prepared scene on the CPU, n iterations at a time, in tiles of `tile` x `tile`
/// pixels: for scenes whose tables a test has changed. `threads`: 0: one per core.
inline Film sampled(const std::shared_ptr<const PreparedScene>& prepared, std::uint64_t samples, std::uint32_t n = 64,
                    int tile = 4096, int threads = 0) {
    const ivec2 size = prepared->flat.camera.film;
    Film film(size, prepared->revision);
    CpuTracer tracer(threads);
    while (film.samplesPerPixel() < samples) {
        const SampleRange range =
            film.nextSamples(std::uint32_t(std::min<std::uint64_t>(n, samples - film.samplesPerPixel())));
        for (int y = 0; y < size.y; y += tile)
            for (int x = 0; x < size.x; x += tile) {
                const Tile piece{x, y, std::min(tile, size.x - x), std::min(tile, size.y - y)};
                tracer.trace(prepared->flat, piece, range, film.sums(piece));
            }
        film.commit(range);
    }
    return film;
}

/// Renders the part `area` of the image, n iterations at a time. The scene must be on the device.
inline std::shared_ptr<const Film> renderedPart(const Scene& scene, const Tile& area, std::uint64_t samples,
                                                Device& device, std::uint32_t n) {
    const auto film = *device.film(area, scene.revision, {});
    for (std::uint64_t done = 0; done < samples; done += n)
        (void)film->accumulate(std::uint32_t(std::min<std::uint64_t>(n, samples - done)), {});
    return *film->film();
}

/// Renders n iterations at a time, in parts of `tile` x `tile` pixels, each a film of its own.
inline Film render(const Scene& scene, std::uint64_t samples, Device& device, std::uint32_t n = 64, int tile = 4096) {
    const ivec2 size = scene.film;
    (void)device.upload(scene);
    FilmContent content = Film(size, scene.revision).content();
    content.progress.advance(wholeImage(size), samples);
    for (int y = 0; y < size.y; y += tile)
        for (int x = 0; x < size.x; x += tile) {
            const Tile area{x, y, std::min(tile, size.x - x), std::min(tile, size.y - y)};
            const FilmContent part = renderedPart(scene, area, samples, device, n)->content();
            for (int row = 0; row < area.height; ++row) {
                const std::ptrdiff_t to = std::ptrdiff_t(y + row) * size.x + x, from = std::ptrdiff_t(row) * area.width;
                std::copy_n(part.moments.begin() + from, area.width, content.moments.begin() + to);
                std::copy_n(part.block.begin() + from, area.width, content.block.begin() + to);
            }
            content.health.add(part.health);
        }
    return Film(scene.revision, std::move(content));
}

inline Film render(const Scene& scene, std::uint64_t samples) {
    const std::unique_ptr<Device> device = testedDevice();
    return render(scene, samples, *device);
}

/// Prepares `scene` so that a test can change what the kernel reads.
inline std::shared_ptr<PreparedScene> prepared(const Scene& scene) {
    return std::const_pointer_cast<PreparedScene>(Flattener().prepare(scene));
}

/// Prepares `scene` with one majorant for all cells: no cell is known to be emptier than another.
inline std::shared_ptr<const PreparedScene> withGlobalMajorant(const Scene& scene) {
    auto result = prepared(scene);
    auto majorants = std::make_shared<Majorants>(*result->majorants);
    const float highest = *std::max_element(majorants->coarse.begin(), majorants->coarse.end());
    majorants->coarse.assign(majorants->coarse.size(), highest);
    majorants->fine.assign(majorants->fine.size(), highest);
    result->viewDepths.assign(result->viewDepths.size(), vec2(0, 1e30f));
    result->flat.majorants.fine = majorants->fine.data();
    result->flat.majorants.coarse = majorants->coarse.data();
    result->flat.majorants.occupiedLow = vec3(-0.5f);
    result->flat.majorants.occupiedHigh = vec3(scene.volume->size()) - 0.5f;
    result->majorants = majorants;
    return result;
}

}  // namespace pdr::test
