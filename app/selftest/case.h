#pragma once
/// The cases of the self-test: scenes that physics knows the answer to. They are data (tests/physics/*.json, compiled
/// into the program); what a scene may be made of is the closed vocabulary below.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/base/result.h"

namespace pdr::selftest {

/// Matter and light of a case. Upward is +z. Whatever is not said is black, empty or straight on.
struct CaseScene {
    enum class Shape {
        slab,     ///< homogeneous layer, practically endless sideways
        sphere,   ///< a homogeneous sphere
        ramp,     ///< the same, but its extinction grows or falls linearly on the way up
        surface,  ///< a slab whose HU rise evenly downwards, by 2048 in all: steep everywhere
        slit,     ///< a thin black plate with a slit in it, seen out of focus through a lens
    };
    Shape shape = Shape::slab;
    double depth = 1;            ///< optical depth: through a slab, along a sphere's radius, through a ramp
    double extinctionPerMm = 1;  ///< of the medium; a ramp: at its bottom. Sets the size in mm.
    double endRatio = 1;         ///< a ramp's extinction at its top / at its bottom
    double albedo = 0;
    double g = 0;               ///< Henyey-Greenstein mean cosine
    double emission = 0;        ///< radiance per optical depth
    double gradientFactor = 0;  ///< of surfaces, as in a scene
    double specular = 0;        ///< reflectance of a surface at normal incidence
    double roughness = 0.5;     ///< of its gloss
    double blur = 0;            ///< a slit: radius of what the lens spreads there, in half widths of the slit
    bool multiple = false;      ///< all orders of scattering; otherwise one
    bool bed = false;           ///< a black, opaque layer under a slab: nothing comes back from there
    enum class Lamp {
        beam,       ///< parallel light
        sphere,     ///< so far away that its light is parallel
        rectangle,  ///< a square as far away
    };
    Lamp lamp = Lamp::beam;
    std::optional<double> beam;  ///< cosine between up and the direction to a lamp of irradiance 1
    enum class Room {
        even,      ///< the same radiance from all around
        sky,       ///< from the upper half only
        gradient,  ///< from above, falling evenly with the height to 0 straight below
    };
    Room roomKind = Room::even;
    double room = 0;      ///< radiance of the surroundings
    double view = 1;      ///< cosine between up and the direction to the camera, which is orthographic
    bool inside = false;  ///< the camera stands inside, at the bottom of a ramp or on the bed of a slab, and looks up
};

/// What is measured, and compared with the expected number.
enum class Quantity {
    radiance,           ///< mean radiance of the picture
    reflectanceFactor,  ///< pi * radiance / (beam cosine * irradiance): 1 for a white Lambert surface
    discTransmittance,  ///< light that a sphere lets through, mean over its disc
    escapeProbability,  ///< fraction of light made evenly in a sphere that leaves it
    freeFlights,        ///< chi-square of distances to the first collision on 64 equally probable bins; expected: 64
    meanCosine,         ///< of sampled scattering directions
    meanSquaredCosine,
};

/// How sharp a run is: so many samples, and the smallest bias (relative; absolute for meanCosine; of the extinction
/// for freeFlights) that it must be able to find nine times out of ten.
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
    double geometryBias = 0;  ///< relative: how far the voxels' shape itself may shift the result
    Sharpness quick, full;
};

struct Family {
    std::string name;
    std::string note;  ///< how it is measured, for the reader of the table
    std::vector<Case> cases;
};

/// A family from its JSON text; `where` names it in errors. Unknown words are errors.
Result<Family> readFamily(std::string_view json, const std::string& where);

/// Every family that was compiled in, in a fixed order.
Result<std::vector<Family>> shippedFamilies();

}  // namespace pdr::selftest
