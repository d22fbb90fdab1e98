#include "render/scene/scene.h"

#include <algorithm>
#include <string>
#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/fields/scene_fields.h"

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
        return Error{
            phrase("kroesMarch knows one event on a path, but the model is %1", std::string(modelName(scene.model))),
            "estimator", phrase("Take the model singleScattering, or the estimator unbiased.")};
    return {};
}

Result<void> checkMask(const Scene& scene) {
    if (scene.mask && scene.volume && scene.mask->grid().voxels != scene.volume->size())
        return Error{phrase("belongs to a volume of another size"), "mask", phrase("Make it of this volume.")};
    return {};
}

template <class T, std::size_t N>
const char* wordFor(const T& value, const Words<T, N>& words) {
    return std::ranges::find(words, value, &std::pair<std::string_view, T>::second)->first.data();
}

}  // namespace

const char* modelName(Model model) {
    return wordFor(model, kModelWords);
}

const char* estimatorName(Estimator estimator) {
    return wordFor(estimator, kEstimatorWords);
}

const char* filteringName(Filtering filtering) {
    return wordFor(filtering, kFilteringWords);
}

Result<void> check(const HuWindow& window) {
    if (auto ok = FieldCheck::check(window, "window"); !ok)
        return ok;
    if (!(window.highHu > window.lowHu))
        return Error{phrase("highHu must lie above lowHu"), "window.highHu", ""};
    return {};
}

bool isProjection(Model model) {
    return model != Model::singleScattering && model != Model::multipleScattering;
}

bool showsEnvironment(const Scene& scene) {
    return scene.environment.visible && !scene.background;
}

bool canBeDenoised(const Scene& scene) {
    return !isProjection(scene.model) && scene.schedule.kind == Schedule::Kind::pd;
}

Result<void> Scene::check() const {
    for (const auto& ok :
         {transferFunction.check(), FieldCheck::check(*this), pdr::check(window), checkEstimator(*this),
          checkLights(*this), camera.check(), checkClip(clip), checkMask(*this), checkParts(*this)})
        if (!ok)
            return ok;
    return {};
}

}  // namespace pdr
