#pragma once
/// A place in the patient and how sure it is: what every measurement is made of. Lengths are millimetres, patient space
/// LPS.

#include <array>

#include "render/volume/volume.h"

namespace pdr::measure {

/// How a place was found.
enum class Found {
    typed,       ///< coordinates were entered: no spread, and texts say so
    onSlice,     ///< clicked on a slice
    atEdge,      ///< clicked on a slice and moved to the half level of an edge
    picked,      ///< clicked on the 3D image: where the light of a pixel stops
    pickedEdge,  ///< picked and moved to the half level of an edge
};

/// Why a place is uncertain.
enum class Cause {
    grid,   ///< voxels are apart: what lies between them is interpolated
    edge,   ///< noise moves the half level of an edge
    hand,   ///< a screen has pixels and a slab has a thickness
    light,  ///< light stops at various depths
};
inline constexpr std::size_t kCauses = 4;

/// The covariance of a place [mm^2] by cause. The causes are independent, so that their covariances add up.
struct Spread {
    std::array<dmat3, kCauses> mm2{dmat3(0), dmat3(0), dmat3(0), dmat3(0)};

    dmat3& of(Cause cause) { return mm2[std::size_t(cause)]; }
    const dmat3& of(Cause cause) const { return mm2[std::size_t(cause)]; }
    dmat3 total() const;
    bool operator==(const Spread&) const = default;
};

struct Place {
    dvec3 mm{0};
    Spread spread;
    Found found = Found::typed;
    double blurMm = 0;  ///< width of the edge, its step over its slope; 0 = not at an edge
    bool thin = false;  ///< at an edge to which another one is so close that the scan blurs the two into one
    bool operator==(const Place&) const = default;
};

/// The plane in which a place was clicked.
struct ClickedPlane {
    dvec3 right, down;      ///< unit vectors along the rows and columns of the screen
    double mmPerPixel = 1;  ///< width of a pixel of the screen; > 0
    double slabMm = 0;      ///< whole thickness of what the plane shows; 0 = a single layer
};

/// Returns whether the place lies on the half level of an edge.
bool isAtEdge(const Place& place);

/// Returns the unit vectors along i, j and k as columns. In a tilted stack they are not orthogonal.
dmat3 gridAxes(const VolumeGeometry& geometry);

/// Returns the step of the grid along the unit vector `direction`, sqrt(sum (s_i u_i)^2) with u_i the cosines to the
/// axes of the grid [mm].
double stepAlongMm(const VolumeGeometry& geometry, dvec3 direction);

/// Returns the smallest distance along the unit vector `direction` at which a scan tells two edges apart that are
/// `blurMm` wide [mm]: the largest of 2.5 mm, 2.5 steps of the grid and two widths.
double resolvedMm(const VolumeGeometry& geometry, dvec3 direction, double blurMm);

/// Returns the place of typed coordinates.
Place typedPlace(dvec3 mm);

/// Returns the place of a click. A uniform distribution of width w has the variance w^2 / 12: voxels along each axis of
/// the grid, the pixels of the screen in its plane, the slab across it.
Place clickedPlace(const VolumeGeometry& geometry, dvec3 mm, const ClickedPlane& plane);

/// Returns the place where light stops along a ray. `alongRay`: unit vector. `depthSigma`, `pixelSigma`: standard
/// deviations along the ray and in each direction across it [mm].
Place pickedPlace(const VolumeGeometry& geometry, dvec3 mm, dvec3 alongRay, double depthSigma, double pixelSigma);

/// Moves `place` to the half level of an edge at `mm`. Along the unit vector `normal`, what was known of the place is
/// replaced by the standard deviations `edgeSigma` (noise) and `gridSigma` (interpolation) [mm]. Along the edge it is
/// where hand or light put it: there the grid moves nothing.
Place movedToEdge(Place place, dvec3 mm, dvec3 normal, double edgeSigma, double gridSigma, double blurMm);

}  // namespace pdr::measure
