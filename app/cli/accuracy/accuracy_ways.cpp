#include "app/cli/accuracy/accuracy_ways.h"

#include <memory>
#include <utility>

#include "render/session/bias_lattice.h"
#include "render/session/known_bias.h"
#include "render/volume/reconstruction.h"

namespace pdr::app {
namespace {

AccuracyWay wayOf(const char* name, Scene scene, const std::string& device) {
    std::string bias = shortcutNames(biasFacts(scene, {}, device));
    return {name, std::move(bias), std::move(scene)};
}

Schedule exposureRenders(bool blurred) {
    return {.kind = Schedule::Kind::kroes, .redundant = false, .filter = blurred, .runningMean = true};
}

}  // namespace

std::vector<AccuracyWay> accuracyWays(const Scene& scene, const std::string& device) {
    std::vector<AccuracyWay> ways{wayOf("as it is", scene, device)};
    const auto add = [&](const char* name, auto change) {
        Scene other = scene;
        change(other);
        if (!(other == scene) && other.check())
            ways.push_back(wayOf(name, std::move(other), device));
    };
    const bool scatters = !isProjection(scene.model);
    if (scene.estimator == Estimator::unbiased && scatters)
        add("Exposure Render's march", [](Scene& s) { s.estimator = Estimator::kroesMarch; });
    if (scene.schedule.kind == Schedule::Kind::pd) {
        add("Exposure Render's order", [](Scene& s) { s.schedule = exposureRenders(false); });
        add("Exposure Render's order, blurred", [](Scene& s) { s.schedule = exposureRenders(true); });
        if (scene.estimator == Estimator::unbiased && scatters)
            add("Exposure Render's march and order, blurred", [](Scene& s) {
                s.estimator = Estimator::kroesMarch;
                s.schedule = exposureRenders(true);
            });
    }
    Scene fast = scene;
    fast.filtering = Filtering::fast;
    if (scene.filtering == Filtering::exact && biasFacts(fast, {}, device).texturesFilter)
        ways.push_back(wayOf("fast filter", std::move(fast), device));
    return ways;
}

std::vector<AccuracyWay> otherImages(const Scene& scene) {
    std::vector<AccuracyWay> others;
    for (const Model model : kModels) {
        Scene other = exactly(scene);
        other.model = model;
        if (model != scene.model)
            others.push_back({modelName(model), "", std::move(other)});
    }
    if (scene.volume && !hasInterpolatedSlices(*scene.volume) && scene.volume->size().z > 1) {
        Scene finer = exactly(scene);
        finer.volume = std::make_shared<const Volume>(reconstructed(*scene.volume, Reconstruction::cubic));
        others.push_back({"interpolated slices", "", std::move(finer)});
    }
    return others;
}

}  // namespace pdr::app
