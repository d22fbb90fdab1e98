#pragma once
/// From a case of the self-test to a scene that any device can render.

#include "app/selftest/case.h"
#include "render/scene/scene.h"

namespace pdr::selftest {

/// The scene of a case, its film included. Right but for `geometryBias`, and for what gets lost through the sides of a
/// slab, 10,000 thicknesses away: a segment must lie within 1e-4 of the horizontal to reach them, and exp(-10,000
/// depth) of the light survives it; diffusing there takes exp(-10,000 pi). Below 1e-8 in every case.
Scene sceneOf(const Case& reference);

/// For freeFlights: the same scene, in which a first collision in bin `bin` of kFlightBins shines with radiance 1, and
/// nothing else does. What is not met at all belongs to the last bin. The bins are equally probable.
Scene flightScene(const Case& reference, int bin);

/// A sphere's radius, half a slit's width, the thickness of anything else [mm].
double extentMm(const CaseScene& scene);

/// Width of the square picture of a sphere, in units of its radius, for quantities that are means over the disc.
inline constexpr double kDiscWidth = 2.1;

}  // namespace pdr::selftest
