#include "render/accuracy/quality.h"

#include <cmath>

namespace pdr {

Quality qualityOf(const FilmStatus& status) {
    if (!std::isfinite(status.displayError))
        return Quality::estimating;
    if (status.displayError > kOrientationLevels || status.fewBrightSamples)
        return Quality::rough;
    if (status.displayError > kPlanningLevels)
        return Quality::orientation;
    return status.displayError > 1 ? Quality::planning : Quality::reference;
}

}  // namespace pdr
