#pragma once
/// Cases of the self-test: scenes whose result is known from physics. They are data (tests/physics/*.json, compiled
/// into the program); CaseScene lists all that a scene may consist of.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/base/result.h"

namespace pdr::selftest {

/// Medium and light of a case. +z points up. Unset fields mean black, empty or straight on.
struct CaseScene {
    enum class Shape {
        slab,     ///< homogeneous layer, practically endless sideways
        sphere,   ///< homogeneous sphere
        ramp,     ///< layer whose extinction grows or falls linearly upwards
        surface,  ///< a slab whose HU rise evenly downwards, by 2048 in all: steep everywhere
        slit,     ///< a thin black plate with a slit in it, seen out of focus through a lens
    };
    Shape shape = Shape::slab;
    double depth = 1;            ///< optical depth: through a slab, along a sphere's radius, through a ramp
    double extinctionPerMm = 1;  ///< extinction of the medium; of a ramp: at its bottom; determines the size in mm
    double endRatio = 1;         ///< a ramp's extinction at its top / at its bottom
    double albedo = 0;
    double g = 0;               ///< Henyey-Greenstein mean cosine
    double emission = 0;        ///< radiance per optical depth
    double gradientFactor = 0;  ///< gradient factor of surfaces, as in Scene
    double specular = 0;        ///< reflectance of a surface at normal incidence
    double roughness = 0.5;     ///< roughness of a surface
    double blur = 0;            ///< for a slit: radius of the lens's blur at the plate, in half widths of the slit
    bool multiple = false;      ///< true: all orders of scattering; false: one
    bool bed = false;           ///< true: a black, opaque layer under a slab, from which nothing comes back
    enum class Lamp {
        beam,       ///< parallel light
        sphere,     ///< sphere so far away that its light is parallel
        rectangle,  ///< square that is equally far away
    };
    Lamp lamp = Lamp::beam;
    std::optional<double> beam;  ///< cosine between up and the direction to a lamp of irradiance 1
    enum class Room {
        even,      ///< equal radiance from all directions
        sky,       ///< radiance from the upper half only
        gradient,  ///< radiance from above that falls linearly with the height to 0 from straight below
    };
    Room roomKind = Room::even;
    double room = 0;      ///< radiance of the environment
    double view = 1;      ///< cosine between up and the direction to the camera, which is orthographic
    bool inside = false;  ///< true: the camera is inside, at the bottom of a ramp or on the bed of a slab, and looks up
};

/// Quantity that is measured and compared with the expected value.
enum class Quantity {
    radiance,           ///< mean radiance of the image
    reflectanceFactor,  ///< pi * radiance / (beam cosine * irradiance): 1 for a white Lambert surface
    discTransmittance,  ///< transmittance of a sphere, mean over its disc
    escapeProbability,  ///< fraction of light emitted uniformly in a sphere that leaves it
    freeFlights,        ///< chi-square of distances to the first collision on 64 equally probable bins; expected: 64
    meanCosine,         ///< mean cosine of sampled scattering directions
    meanSquaredCosine,
};

/// Sharpness of a run: its number of samples, and the smallest bias (relative; absolute for meanCosine; of the
/// extinction for freeFlights) that it must detect nine times out of ten.
struct Sharpness {
    std::uint64_t samples = 0;
    double detects = 0;
};

struct Case {
    std::string name;
    std::string source;
    CaseScene scene;
    Quantity quantity = Quantity::radiance;
    double expected = 0;
    double geometryBias = 0;  ///< largest relative shift of the result that the voxels' shape itself may cause
    Sharpness quick, full;
};

struct Family {
    std::string name;
    std::string note;  ///< how the cases are measured, for the reader of the table
    std::vector<Case> cases;
};

/// Reads a family from its JSON text. `where` names the text in errors. Unknown words are errors.
Result<Family> readFamily(std::string_view json, const std::string& where);

/// Returns all compiled-in families in a fixed order.
Result<std::vector<Family>> shippedFamilies();

}  // namespace pdr::selftest
