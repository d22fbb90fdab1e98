#include "app/cli/effects_command.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "app/cli/render_options.h"
#include "app/cli/run_command.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/film/tone_map.h"
#include "render/scene/needs.h"

namespace pdr::app {
namespace {

constexpr int kLongestSide = 256;          ///< pixels of the picture that is measured
constexpr std::uint32_t kIterations = 64;  ///< one block
constexpr std::size_t kRounds = 3;         ///< with and without in turn; the median counts

struct Trial {
    double milliseconds;  ///< per iteration
    std::vector<std::uint8_t> picture;
};

Result<Trial> tried(const LoadedScene& loaded, Device& device, Flattener& flattener) {
    const Scene& scene = loaded.scene;
    if (auto ok = device.upload(flattener.prepare(scene)); !ok)
        return ok.error();
    Film film(scene.film, scene.revision);
    const Tile whole{0, 0, scene.film.x, scene.film.y};
    const SampleRange samples = film.nextSamples(kIterations);
    const auto start = std::chrono::steady_clock::now();
    if (auto ok = device.render(whole, samples, film.sums(whole), {}); !ok)
        return ok.error();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    film.commit(samples);
    return Trial{took.count() / kIterations, toneMap(film, loaded.display)};
}

/// Mean over pixels and colours; both pictures are made with the same random numbers.
double changedLevels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(int(a[i]) - int(b[i]));
    return sum / (double(a.size()) * 3 / 4);  // alpha never changes
}

struct Cost {
    double milliseconds, levels;
};

Result<Cost> costOf(const Effect& effect, const LoadedScene& with, Device& device, Flattener& flattener) {
    LoadedScene without = with;
    effect.leaveOut(without.scene);
    std::array<double, kRounds> saved;
    double levels = 0;
    for (double& round : saved) {
        const auto full = tried(with, device, flattener), lean = tried(without, device, flattener);
        if (!full || !lean)
            return full ? lean.error() : full.error();
        round = full->milliseconds - lean->milliseconds;
        levels = changedLevels(full->picture, lean->picture);
    }
    std::ranges::sort(saved);
    return Cost{saved[kRounds / 2], levels};
}

Result<void> printTable(const LoadedScene& loaded, Device& device) {
    Flattener flattener;
    const auto all = tried(loaded, device, flattener);
    if (!all)
        return all.error();
    std::printf("%d x %d pixels, %.2f ms per iteration on %s, %s\n\n", loaded.scene.film.x, loaded.scene.film.y,
                all->milliseconds, device.info().name.c_str(), device.info().details.c_str());
    std::printf("%-24s %-7s %9s %8s  %s\n", "effect", "", "ms", "levels", "because");
    for (const Effect& effect : needs(loaded.scene)) {
        std::string figures(18, ' ');
        if (effect.needed && effect.leaveOut) {
            const auto cost = costOf(effect, loaded, device, flattener);
            if (!cost)
                return cost.error();
            std::snprintf(figures.data(), figures.size() + 1, "%9.2f %8.2f", cost->milliseconds, cost->levels);
        }
        std::printf("%-24s %-7s %s  %s\n", effect.name.c_str(), effect.needed ? "needed" : "off", figures.c_str(),
                    effect.reason.c_str());
        std::fflush(stdout);
    }
    return {};
}

/// The same scene under every model, in turn: what each costs, so that the slowest cannot tax the simplest unseen.
Result<void> printModels(const LoadedScene& loaded, Device& device) {
    std::array<std::array<double, kRounds>, std::size(kModels)> milliseconds{};
    Flattener flattener;
    for (std::size_t round = 0; round < kRounds; ++round)
        for (std::size_t i = 0; i < std::size(kModels); ++i) {
            LoadedScene work = loaded;
            work.scene.model = kModels[i];
            if (!work.scene.check())
                work.scene.estimator = Estimator::unbiased;  // of the other models there is no other
            const auto trial = tried(work, device, flattener);
            if (!trial)
                return trial.error();
            milliseconds[i][round] = trial->milliseconds;
        }
    std::printf("\n%-24s %17s\n", "model", "ms per iteration");
    for (std::size_t i = 0; i < std::size(kModels); ++i) {
        std::ranges::sort(milliseconds[i]);
        std::printf("%-24s %17.2f%s\n", modelName(kModels[i]), milliseconds[i][kRounds / 2],
                    kModels[i] == loaded.scene.model ? "  (this one)" : "");
    }
    return {};
}

Result<void> listEffects(const EffectsOptions& options) {
    auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    ivec2& film = loaded->scene.film;
    film = glm::max(film * kLongestSide / std::max({film.x, film.y, kLongestSide}), ivec2(1));
    const auto device = makeCpuDevice(options.threads);
    if (auto ok = printTable(*loaded, *device); !ok)
        return ok;
    return printModels(*loaded, *device);
}

}  // namespace

int runEffects(const QStringList& arguments) {
    return runCommand("effects", effectsOptions(arguments), effectsHelp, [](const EffectsOptions& options) {
        const auto done = listEffects(options);
        return done ? 0 : failed(done.error());
    });
}

}  // namespace pdr::app
