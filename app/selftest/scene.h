#pragma once
/// Conversion of a case of the self-test to a scene that any device can render.

#include "app/selftest/case.h"
#include "render/scene/scene.h"

namespace pdr::selftest {

/// Returns the scene of a case, its film included. It is exact except for `geometryBias` and for what is lost through
/// the sides of a slab, 10,000 thicknesses away: a segment must lie within 1e-4 of the horizontal to reach them, and
/// exp(-10,000 depth) of the light survives it; diffusion to the sides leaves exp(-10,000 pi). The loss is below 1e-8
/// in every case.
Scene sceneOf(const Case& reference);

/// Returns the scene for freeFlights: that of the case, but a first collision in bin `bin` of kFlightBins emits
/// radiance 1, and nothing else does. Paths without a collision belong to the last bin. The bins are equally probable.
Scene flightScene(const Case& reference, int bin);

/// Returns a sphere's radius, half of a slit's width, or the thickness of any other shape [mm].
double extentMm(const CaseScene& scene);

/// Width of the square image of a sphere, in units of its radius, for quantities that are means over the disc.
inline constexpr double kDiscWidth = 2.1;

}  // namespace pdr::selftest
