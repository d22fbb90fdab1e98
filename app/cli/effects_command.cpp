#include "app/cli/effects_command.h"

#include <algorithm>
#include <cstdio>

#include "app/cli/effects_report.h"
#include "app/cli/render_options.h"
#include "app/cli/run_command.h"
#include "render/scene/scene.h"

namespace pdr::app {
namespace {

constexpr int kLongestSide = 256;     ///< pixels of the picture that is measured, at most
constexpr double kEffectSeconds = 7;  ///< of processor time for all effects
constexpr double kModelSeconds = 3;   ///< and for all models
/// So many iterations are hoped for in each measurement: fewer say little of the picture.
constexpr int kWantedIterations = 8;

bool canBeTried(const Effect& effect) {
    return effect.needed && effect.leaveOut != nullptr;
}

Result<std::vector<TriedEffect>> triedEffects(const LoadedScene& loaded, Device& device, double secondsEach) {
    std::vector<TriedEffect> all;
    for (Effect& effect : needs(loaded.scene)) {
        TriedEffect& tried = all.emplace_back(TriedEffect{std::move(effect)});
        if (!canBeTried(tried.effect))
            continue;
        const auto trial = tryEffect(tried.effect, loaded.scene, loaded.display, device, secondsEach);
        if (!trial)
            return trial.error();
        tried.trial = *trial;
    }
    return all;
}

/// The same scene under every model, in turn: what each costs, so that the slowest cannot tax the simplest unseen.
Result<std::vector<TriedModel>> triedModels(const Scene& scene, Device& device) {
    std::vector<TrialPicture> pictures;
    for (const Model model : kModels) {
        Scene other = scene;
        other.model = model;
        if (!other.check())
            other.estimator = Estimator::unbiased;  // of the other models there is no other
        pictures.emplace_back(std::move(other), device);
    }
    std::vector<Iterate> iterates;
    for (TrialPicture& picture : pictures)
        iterates.push_back([&picture](std::uint32_t n) { return picture.accumulate(n); });
    const auto costs = costsInTurn(iterates, kModelSeconds);
    if (!costs)
        return costs.error();
    std::vector<TriedModel> models;
    for (std::size_t i = 0; i < std::size(kModels); ++i)
        models.push_back({kModels[i], (*costs)[i]});
    return models;
}

Result<EffectsReport> listEffects(const EffectsOptions& options) {
    auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    const auto device = makeCpuDevice(options.threads);
    const std::vector<Effect> effects = needs(loaded->scene);
    const auto tried = std::max<std::ptrdiff_t>(1, std::ranges::count_if(effects, canBeTried));
    const double secondsEach = kEffectSeconds / double(tried);
    const auto film =
        trialFilm(loaded->scene, *device, kLongestSide, secondsEach / (2 * kBandMeasurements * kWantedIterations));
    if (!film)
        return film.error();
    loaded->scene.film = *film;

    EffectsReport report{
        .film = *film, .device = device->info(), .model = loaded->scene.model, .effects = {}, .models = {}};
    auto ledger = triedEffects(*loaded, *device, secondsEach);
    if (!ledger)
        return ledger.error();
    report.effects = *std::move(ledger);
    auto models = triedModels(loaded->scene, *device);
    if (!models)
        return models.error();
    report.models = *std::move(models);
    return report;
}

}  // namespace

int runEffects(const QStringList& arguments) {
    return runCommand("effects", effectsOptions(arguments), effectsHelp, [](const EffectsOptions& options) {
        const auto report = listEffects(options);
        if (!report)
            return failed(report.error());
        std::fputs((options.json ? jsonText(*report) : plainText(*report)).c_str(), stdout);
        return 0;
    });
}

}  // namespace pdr::app
