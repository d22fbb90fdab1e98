#include "app/bench/filtering/price.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "app/bench/median.h"
#include "render/base/srgb.h"
#include "render/film/film.h"
#include "render/kernel/volume_sampling.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

double steepestCell(const FlatVolume& volume) {
    float most = 0;
    for (int k = 0; k <= int(volume.lastCorner.z); ++k)
        for (int j = 0; j <= int(volume.lastCorner.y); ++j)
            for (int i = 0; i <= int(volume.lastCorner.x); ++i) {
                const auto [low, high] = std::ranges::minmax(cellAt(volume, Vec3<int>{i, j, k}).hu);
                most = std::max(most, high - low);
            }
    return most;
}

/// Returns displayLevel() without rounding, because differences of less than a level count, too.
double shownLevel(double radiance) {
    return 255 * srgbFromLinear(-std::expm1(-std::max(radiance, 0.0)));
}

double standardErrorInLevels(double mean, double error) {
    return (shownLevel(mean + error) - shownLevel(mean - error)) / 2;
}

struct Run {
    std::shared_ptr<const Film> film;
    double seconds = 0;
};

Result<Run> timed(Device& device, const Scene& scene, std::uint32_t samples) {
    if (const auto uploaded = device.upload(scene); !uploaded)
        return uploaded.error();
    const auto film = device.film(scene.film, scene.revision, {});
    if (!film)
        return film.error();
    const auto start = std::chrono::steady_clock::now();
    if (const auto accumulated = (*film)->accumulate(samples, {}); !accumulated)
        return accumulated.error();
    auto made = (*film)->film();
    if (!made)
        return made.error();
    return Run{*made, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

}  // namespace

HuPrice huPrice(const FlatVolume& volume, int places, std::uint64_t seed) {
    FlatVolume exact = volume, fast = volume;
    exact.texture = 0;
    fast.texture = 1;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<float> errors(static_cast<std::size_t>(places));
    double squares = 0;
    for (float& error : errors) {
        const float x = unit(random), y = unit(random), z = unit(random);
        const vec3 place = vec3(x, y, z) * vec3(volume.size) - 0.5f;
        error = std::fabs(hounsfield(fast, place) - hounsfield(exact, place));
        squares += double(error) * error;
    }
    std::ranges::sort(errors);
    const auto last = double(errors.size() - 1);
    return {places, std::sqrt(squares / places), errors[std::size_t(0.999 * last)], errors.back(),
            textureError(float(steepestCell(volume)))};
}

LevelPrice levelPrice(const Film& exact, const Film& fast) {
    LevelPrice price;
    std::size_t off = 0;
    for (int y = 0; y < exact.size().y; ++y)
        for (int x = 0; x < exact.size().x; ++x) {
            const PixelEstimate one = exact.pixel(x, y), other = fast.pixel(x, y);
            if (one.mean == other.mean && one.standardError == dvec3(0))
                continue;
            double worst = 0;
            for (int channel = 0; channel < 3; ++channel) {
                const double difference = shownLevel(other.mean[channel]) - shownLevel(one.mean[channel]);
                worst = std::max(worst, std::fabs(difference));
                price.mean += std::fabs(difference);
                price.shift += difference;
                price.standardError += standardErrorInLevels(one.mean[channel], one.standardError[channel]);
            }
            price.largest = std::max(price.largest, worst);
            off += worst > 1;
            ++price.pixels;
        }
    const double pixels = double(std::max<std::size_t>(price.pixels, 1));
    for (double* sum : {&price.mean, &price.shift, &price.standardError})
        *sum /= 3 * pixels;
    price.offByOne = double(off) / pixels;
    return price;
}

Result<ImagePrice> imagePrice(Device& device, const Scene& scene, std::uint32_t samples, int rounds) {
    constexpr Filtering kTurns[] = {Filtering::exact, Filtering::fast};
    Scene filtered[] = {scene, scene};
    for (int way = 0; way < 2; ++way) {
        filtered[way].filtering = kTurns[way];
        if (const auto warm = timed(device, filtered[way], 1); !warm)
            return warm.error();
    }
    std::shared_ptr<const Film> films[2];
    std::vector<double> seconds[2];
    for (int turn = 0; turn < 2 * rounds; ++turn) {
        const int way = (turn + turn / 2) % 2;  // 0 1 1 0: neither is always the second
        const Result<Run> run = timed(device, filtered[way], samples);
        if (!run)
            return run.error();
        films[way] = run->film;
        seconds[way].push_back(run->seconds);
    }
    return ImagePrice{levelPrice(*films[0], *films[1]), median(seconds[0]), median(seconds[1])};
}

}  // namespace pdr::bench
