#pragma once
/// The edge of a structure near a place: where the HU are halfway between the tissue on either side. It is found from
/// the voxels alone, so that neither the window of a slice nor the look of an image moves it.

#include <optional>

#include "render/base/text.h"
#include "render/measure/place.h"

namespace pdr::measure {

/// The farthest that a place is moved to an edge [mm].
inline constexpr double kEdgeReachMm = 2.5;

struct Edge {
    dvec3 mm;      ///< on the half level
    dvec3 normal;  ///< unit vector across the edge, towards the higher HU
    double lowHu, highHu;
    double noiseHu;    ///< standard deviation of a voxel
    double blurMm;     ///< width of the edge: its step over its slope
    double edgeSigma;  ///< standard deviation by noise [mm]
    double gridSigma;  ///< standard deviation by the interpolation between voxels [mm]
    bool thin;         ///< another edge is closer than resolvedMm()
};

/// Why there is no edge at a place.
enum class NoEdge {
    outside,  ///< the place is not in the scan, or too close to its border
    far,      ///< the HU rise nowhere, or are halfway only farther away than kEdgeReachMm
    faint,    ///< the sides differ by less than five standard deviations of the noise
    padding,  ///< the scanner measured nothing on one side
    cramped,  ///< there are too few voxels on either side to know the noise
};

struct EdgeSearch {
    std::optional<Edge> edge;
    NoEdge why = NoEdge::far;  ///< if there is none
};

/// Looks for the edge along the gradient of the HU at `mm`. With `inPlane`, the unit normal of a plane, it goes along
/// the part of the gradient in that plane, so that what was clicked on a slice stays in it.
///   profile   the mean over a disc of 1 mm radius across the line
///   levels    on either side, the median from 2 to 5 mm behind the edge; where another edge is nearer than that, the
///             mean of the 1 mm in the middle between the two
EdgeSearch edgeNear(const Volume& volume, dvec3 mm, std::optional<dvec3> inPlane = {});

/// Returns `place` moved to an edge near it.
Place atEdge(const Place& place, const Edge& edge);

/// Returns why there is no edge, as a phrase for the user.
Text noEdgeText(NoEdge why);

}  // namespace pdr::measure
