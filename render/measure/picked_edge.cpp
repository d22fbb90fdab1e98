#include "render/measure/picked_edge.h"

#include <cmath>

namespace pdr::measure {
namespace {

/// Sine of the smallest angle between a ray and an edge at which the ray says where on the edge a place lies.
constexpr double kGrazing = 0.34;

/// Returns `picked` moved along its ray to the plane of `edge`.
Place alongTo(const Edge& edge, Place picked, dvec3 alongRay) {
    const double slope = glm::dot(alongRay, edge.normal);
    // Along the ray into the plane of the edge: what spreads along the ray does not count.
    const dmat3 intoPlane = dmat3(1) - glm::outerProduct(alongRay, edge.normal) / slope;
    for (dmat3& share : picked.spread.mm2) {
        share = intoPlane * share * glm::transpose(intoPlane);
        share = 0.5 * (share + glm::transpose(share));  // to the last bit, as files keep it
    }
    // An edge that is off along its normal moves the place along the ray.
    const dmat3 moved = glm::outerProduct(alongRay, alongRay) / (slope * slope);
    picked.spread.of(Cause::edge) = edge.edgeSigma * edge.edgeSigma * moved;
    picked.spread.of(Cause::grid) = edge.gridSigma * edge.gridSigma * moved;
    picked.spread.of(Cause::light) = dmat3(0);
    picked.mm += glm::dot(edge.mm - picked.mm, edge.normal) / slope * alongRay;
    picked.found = Found::pickedEdge;
    picked.blurMm = edge.blurMm;
    picked.thin = edge.thin;
    return picked;
}

}  // namespace

Place onEdge(const Volume& volume, const Place& picked, dvec3 alongRay) {
    std::optional<Edge> edge = edgeNear(volume, picked.mm).edge;
    if (!edge)
        return picked;
    const auto grazes = [&] { return std::abs(glm::dot(alongRay, edge->normal)) < kGrazing; };
    if (grazes())
        return atEdge(picked, *edge);
    const Place first = alongTo(*edge, picked, alongRay);
    // Where the place has moved along a curved surface, the edge there is another one.
    const std::optional<Edge> there = edgeNear(volume, first.mm).edge;
    if (!there || glm::distance(there->mm, first.mm) > glm::distance(edge->mm, picked.mm))
        return first;
    edge = there;
    return grazes() ? first : alongTo(*edge, picked, alongRay);
}

}  // namespace pdr::measure
