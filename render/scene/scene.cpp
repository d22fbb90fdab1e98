#include "render/scene/scene.h"

#include <string>

#include "render/scene/range.h"

namespace pdr {
namespace {

Result<void> checkLights(const Scene& scene) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (auto ok = check(scene.lights[i]); !ok)
            return below("lights[" + std::to_string(i) + "]", ok.error());
    if (auto ok = check(scene.environment); !ok)
        return below("environment", ok.error());
    return {};
}

Result<void> checkClip(const Clip& clip) {
    const Result<void> ok = clip.check();
    return ok ? ok : below("clip", ok.error());
}

Result<void> checkEstimator(const Scene& scene) {
    if (scene.estimator == Estimator::kroesMarch && scene.model != Model::singleScattering)
        return Error{"kroesMarch knows one event on a path, but the model is " + std::string(modelName(scene.model)),
                     "estimator", "Take the model singleScattering, or the estimator unbiased."};
    return {};
}

Result<void> checkTransport(const Scene& scene) {
    for (const auto& ok :
         {checkRange(scene.phaseG, {-1, 1, false, false}, "phase.g"),
          checkRange(scene.gradientFactor, {0, 1e6}, "surface.gradientFactor"),
          checkRange(scene.maxBounces, {1, 100000}, "maxBounces"),
          checkRange(scene.toleranceLevels, {1e-3, 16}, "toleranceLevels"), check(scene.window), checkEstimator(scene),
          checkRange(scene.film.x, {1, 16384}, "film.width"), checkRange(scene.film.y, {1, 16384}, "film.height")})
        if (!ok)
            return ok;
    return {};
}

}  // namespace

const char* modelName(Model model) {
    switch (model) {
        case Model::absorption:
            return "absorption";
        case Model::emission:
            return "emission";
        case Model::emissionAbsorption:
            return "emissionAbsorption";
        case Model::singleScattering:
            return "singleScattering";
        case Model::multipleScattering:
            return "multipleScattering";
        case Model::maximumIntensity:
            break;
    }
    return "maximumIntensity";
}

const char* estimatorName(Estimator estimator) {
    return estimator == Estimator::unbiased ? "unbiased" : "kroesMarch";
}

const char* filteringName(Filtering filtering) {
    return filtering == Filtering::exact ? "exact" : "fast";
}

Result<void> check(const HuWindow& window) {
    for (const auto& ok : {checkRange(window.lowHu, {-32768, 32767}, "window.lowHu"),
                           checkRange(window.highHu, {-32768, 32767}, "window.highHu")})
        if (!ok)
            return ok;
    if (!(window.highHu > window.lowHu))
        return Error{"highHu must lie above lowHu", "window.highHu", ""};
    return {};
}

bool isProjection(Model model) {
    return model != Model::singleScattering && model != Model::multipleScattering;
}

Result<void> Scene::check() const {
    for (const auto& ok :
         {transferFunction.check(), checkTransport(*this), checkLights(*this), camera.check(), checkClip(clip)})
        if (!ok)
            return ok;
    return {};
}

}  // namespace pdr
