#include "render/measure/picked_edge.h"

#include <cmath>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

/// Sine of the smallest angle between a ray and an edge at which the ray says where on the edge a place lies: 15
/// degrees.
constexpr double kGrazing = 0.26;

/// A place that has moved less than this along a curved surface lies on its edge [mm].
constexpr double kAtRestMm = 0.02;
constexpr int kMostMoves = 4;

/// How far before or behind an edge looks show it, as a standard deviation along the ray [mm]: up to 2 mm.
constexpr double kLookMm = 1.2;

/// The sharpest curve of a surface that is allowed for [mm], and the radius of the disc over which edgeNear() averages.
constexpr double kSharpestMm = 20, kDiscMm = 1;

/// Returns by how much voxels and the disc cut the corners of a surface that curves by kSharpestMm [mm]: the height of
/// an arc over the largest step of the grid along the surface, and its mean over the disc.
double cornersMm(const VolumeGeometry& geometry, dvec3 normal) {
    const dmat3 axes = gridAxes(geometry), along = dmat3(1) - glm::outerProduct(normal, normal);
    const dvec3 spacing = geometry.spacingMm();
    dmat3 squares(0);
    for (int i = 0; i < 3; ++i)
        squares += spacing[i] * spacing[i] * glm::outerProduct(axes[i], axes[i]);
    return (largestVariance(along * squares * along) / 8 + kDiscMm * kDiscMm / 4) / kSharpestMm;
}

/// Returns the edge near a place of a surface that may curve; none: there is none.
std::optional<Edge> curvedEdgeNear(const Volume& volume, dvec3 mm) {
    std::optional<Edge> edge = edgeNear(volume, mm).edge;
    if (edge)
        edge->gridSigma = std::hypot(edge->gridSigma, cornersMm(volume.geometry(), edge->normal));
    return edge;
}

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

Place offEdge(Place picked, dvec3 alongRay) {
    picked.spread.of(Cause::light) += kLookMm * kLookMm * glm::outerProduct(alongRay, alongRay);
    return picked;
}

Place onEdge(const Volume& volume, const Place& picked, dvec3 alongRay) {
    std::optional<Edge> edge = curvedEdgeNear(volume, picked.mm);
    if (!edge)
        return offEdge(picked, alongRay);
    Place place = picked;
    for (int move = 0; edge && move < kMostMoves; ++move) {
        if (std::abs(glm::dot(alongRay, edge->normal)) < kGrazing)
            return atEdge(offEdge(picked, alongRay), *edge);
        const dvec3 before = place.mm;
        Place from = picked;
        from.mm = before;
        place = alongTo(*edge, from, alongRay);
        if (glm::distance(place.mm, before) < kAtRestMm)
            break;
        edge = curvedEdgeNear(volume, place.mm);  // the edge of a curved surface is another one there
    }
    return place;
}

}  // namespace pdr::measure
