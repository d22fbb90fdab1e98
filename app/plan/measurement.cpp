#include "app/plan/measurement.h"

#include "render/measure/angle.h"
#include "render/measure/distance.h"

namespace pdr::app {

Result<measure::Stated> valueOf(const Measurement& measurement, const VolumeGeometry& geometry) {
    const std::vector<measure::Place>& places = measurement.places;
    if (measurement.kind == MeasureKind::distance)
        return measure::distance(geometry, places[0], places[1]);
    return measure::angle(places[0], places[1], places[2]);
}

}  // namespace pdr::app
