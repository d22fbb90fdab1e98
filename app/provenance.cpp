#include "app/provenance.h"

namespace pdr::app {

Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds) {
    return {status.samplesPerPixel,
            seconds,
            status.relativeError,
            status.health,
            scene.seed,
            modelName(scene.model),
            scene.transferFunction.extinctionPerMm,
            "PD-Render " PDR_VERSION,
            scene.estimator == Estimator::unbiased ? "" : std::string(estimatorName(scene.estimator)) + " (biased)"};
}

}  // namespace pdr::app
