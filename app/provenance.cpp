#include "app/provenance.h"

#include "render/base/version.h"
#include "render/prepare/warnings.h"
#include "render/scene/scene.h"

namespace pdr::app {

std::string scheduleText(const Schedule& schedule) {
    if (schedule.kind == Schedule::Kind::pd)
        return {};
    return std::string("Exposure Render's ") + (schedule.redundant ? "K0" : "K1") +
           (schedule.filter ? ", blurred" : "");
}

Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds) {
    return {status.samplesPerPixel,
            seconds,
            status.relativeError,
            status.health,
            scene.seed,
            modelName(scene.model),
            scene.transferFunction.extinctionPerMm,
            "PD-Render " PDR_VERSION,
            scene.estimator == Estimator::unbiased ? "" : "kroesMarch (biased)",
            scheduleText(scene.schedule),
            warningNames(warnings(scene)),
            scene.volume ? scene.volume->remarks() : std::string()};
}

}  // namespace pdr::app
