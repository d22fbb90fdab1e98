#include "app/presenters/mark_places.h"

#include "render/measure/picked_edge.h"
#include "render/measure/trilinear.h"

namespace pdr::app {

bool isInScan(const Volume& volume, dvec3 placeMm) {
    return measure::GridPlace(volume.geometry()).contains(placeMm);
}

measure::Place placeOnSlice(const Volume& volume, const SlicePlane& plane, dvec3 placeMm, bool toEdge) {
    const measure::Place clicked =
        measure::clickedPlace(volume.geometry(), placeMm, {plane.right, plane.down, plane.mmPerPixel, 0});
    if (!toEdge)
        return clicked;
    const measure::EdgeSearch search = measure::edgeNear(volume, placeMm, plane.normal());
    return search.edge ? measure::atEdge(clicked, *search.edge) : clicked;
}

measure::Place placeInPlane(const Volume& volume, const SlicePlane& plane, dvec3 placeMm, bool toEdge, dvec3 onPlaneMm,
                            dvec3 normal) {
    constexpr double kAlong = 1e-9;
    const bool along = glm::length(glm::cross(plane.normal(), normal)) < kAlong;
    return placeOnSlice(volume, plane, placeMm - glm::dot(placeMm - onPlaneMm, normal) * normal, toEdge && along);
}

measure::Place placeInImage(const Volume& volume, const PickedPlace& picked, bool toEdge) {
    const SeenLayer& layer = picked.layer;
    const measure::Place place = measure::pickedPlace(volume.geometry(), layer.placeMm, picked.direction,
                                                      layer.sigmaAlongMm, layer.sigmaAcrossMm);
    return toEdge ? measure::onEdge(volume, place, picked.direction) : measure::offEdge(place, picked.direction);
}

}  // namespace pdr::app
