#include "render/session/known_bias.h"

#include "render/film/film_status.h"
#include "render/kernel/texture.h"
#include "render/prepare/warnings.h"
#include "render/scene/scene.h"
#include "render/volume/reconstruction.h"

namespace pdr {
namespace {

Text denseWarning(const Scene& scene) {
    Text text;
    for (const Warning& warning : warnings(scene))
        text = text.empty() ? warning.text : phrase("%1; %2", text, warning.text);
    return text;
}

}  // namespace

bool texturesFilter(const Scene& scene, const std::string& device) {
    return scene.filtering == Filtering::fast && !isProjection(scene.model) && device != "cpu" && scene.volume &&
           textureHolds(scene.volume->storedRange());
}

BiasFacts biasFacts(const Scene& scene, const FilmStatus& status, const std::string& device) {
    BiasFacts facts;
    facts.model = scene.model;
    facts.estimator = scene.estimator;
    facts.schedule = scene.schedule;
    facts.texturesFilter = texturesFilter(scene, device);
    facts.toleranceLevels = scene.toleranceLevels;
    facts.denseWarning = denseWarning(scene);
    facts.health = status.health;
    facts.tissuePixels = status.tissuePixels;
    facts.slicesInterpolated = scene.volume && hasInterpolatedSlices(*scene.volume);
    return facts;
}

}  // namespace pdr
