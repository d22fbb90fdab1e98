#include "app/provenance.h"

namespace pdr::app {

std::string comparisonText(const Schedule& schedule, Estimator estimator) {
    std::string text;
    if (schedule.kind == Schedule::Kind::kroes) {
        text = std::string("Exposure Render's schedule ") + (schedule.redundant ? "K0" : "K1");
        if (schedule.filter)
            text += ", blurred";
    }
    if (estimator == Estimator::kroesMarch)
        text += std::string(text.empty() ? "" : " and ") + "Exposure Render's march, biased";
    return text;
}

Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds, const Schedule& schedule) {
    return {status.samplesPerPixel,
            seconds,
            status.relativeError,
            status.health,
            scene.seed,
            modelName(scene.model),
            scene.transferFunction.extinctionPerMm,
            "PD-Render " PDR_VERSION,
            comparisonText(schedule, scene.estimator)};
}

}  // namespace pdr::app
