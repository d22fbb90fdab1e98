#include "app/cli/effects/effects_command.h"

#include <cstdio>

#include "app/cli/effects/effects_report.h"
#include "app/cli/render/render_options.h"
#include "app/cli/run_command.h"
#include "render/scene/scene.h"

namespace pdr::app {
namespace {

constexpr Calibration::Effort kEffort{.longestSide = 256, .seconds = 7};
constexpr double kModelSeconds = 3;  ///< processor time for all models

/// Measures what the scene costs under each model. The models take turns. The list of all models shows if the code of
/// the slowest makes the simplest one slower.
Result<std::vector<TriedModel>> triedModels(const Scene& scene, Device& device) {
    std::vector<TrialImage> images;
    images.reserve(std::size(kModels));
    for (const Model model : kModels) {
        Scene other = scene;
        other.model = model;
        if (!other.check())
            other.estimator = Estimator::unbiased;  // the other models have no other estimator
        images.emplace_back(std::move(other), device, TrialImage::Use::shared);
    }
    std::vector<Iterate> iterates;
    iterates.reserve(images.size());
    for (TrialImage& image : images)
        iterates.push_back(
            [&image](std::uint32_t n, const std::stop_token& stop) { return image.accumulate(n, stop); });
    CostsInTurn costs(std::move(iterates), kModelSeconds);
    while (!costs.isDone())
        if (auto ok = costs.step(); !ok)
            return ok.error();
    const std::vector<CostBand> bands = costs.bands();
    std::vector<TriedModel> models;
    models.reserve(bands.size());
    for (std::size_t i = 0; i < std::size(kModels); ++i)
        models.push_back({kModels[i], bands[i]});
    return models;
}

Result<EffectsReport> listEffects(const EffectsOptions& options) {
    const auto loaded = loadSceneShown(options.scene);
    if (!loaded)
        return loaded.error();
    const auto device = makeCpuDevice(options.threads);
    const auto other = makeCpuDevice(options.threads);
    Calibration calibration(loaded->scene, loaded->display, {*device, *other}, kEffort);
    while (!calibration.isDone())
        if (auto ok = calibration.step(); !ok)
            return ok.error();
    auto models = triedModels(calibration.scene(), *device);
    if (!models)
        return models.error();
    return EffectsReport{calibration.effectCosts(), *std::move(models)};
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
