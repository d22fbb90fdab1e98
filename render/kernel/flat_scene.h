#pragma once
/// The scene as the kernel reads it: plain numbers and pointers into arrays that somebody else owns (scene/flatten).
///   index space   voxel (i,j,k) is centred at (i,j,k); the volume's box is [-0.5, size - 0.5]
///   local space   patient axes (LPS), millimetres, origin at the volume's centre
///   along a ray   distances t in mm; a ray's index-space direction is indexFromLocal * (unit local direction)

#include <cstdint>

#include "render/base/portable.h"
#include "render/base/seen.h"

namespace pdr {

/// One linear piece of the transfer function: opacity(hu) = opacity + slope * (hu - start) for hu in [start, end).
struct alignas(16) OpacityPiece {  // a GPU reads it at once
    float start, end;
    float opacity, slope;
    bool operator==(const OpacityPiece&) const = default;
};

/// Optical properties at one end of a piece; meanings as in TransferNode.
struct Material {
    vec3 albedo;
    vec3 emission;
    vec3 specular;
    float roughness;
};

/// pieces[pieceAt[(hu - INT16_MIN) / 16]] is the first piece that may hold hu. The first begins below any HU, the last
/// has no end.
struct FlatTransferFunction {
    const OpacityPiece* pieces;
    const Material* materials;  ///< two per piece: at its start and at its end
    const std::uint16_t* pieceAt;
    int pieceCount;
    float extinctionPerMm;
};

/// Numbers on a grid, read trilinearly between its voxels.
struct FlatGrid {
    const std::int16_t* voxels;
    ivec3 size;
    vec3 lastIndex;   ///< size - 1
    vec3 lastCorner;  ///< max(size - 2, 0): where the last interpolation cell begins
    int stepX;        ///< voxels to the next along x, y, z; 0 where there is only one
    std::int64_t stepY, stepZ;
};

struct FlatVolume : FlatGrid {
    dmat3 exactIndexFromLocal;  ///< linear part, 1/mm
    mat3 indexFromLocal;        ///< the same in single precision
    mat3 localFromIndex;        ///< linear part, mm
    std::uint64_t texture;      ///< of a GPU, to be filtered by its texture units (kernel/texture.h); 0: exactly
};

/// What is seen of the volume (volume/mask.h): weights from 0 to kSeen on a grid of its own, whose node (i,j,k) is
/// voxel (i,j,k) << shift. The last node lies on or beyond the last voxel, so that a cell between voxels lies in one
/// between nodes. Without a mask `voxels` is null.
struct FlatMask : FlatGrid {
    ivec3 shift;
    vec3 nodesPerVoxel;  ///< 2^-shift
};

/// Bounds on the extinction [1/mm] in cells of a grid; see volume/ranges.h for where the cells lie.
struct FlatMajorants {
    const float* fine;
    const float* coarse;
    ivec3 fineSize;
    ivec3 coarseSize;
    vec3 occupiedLow, occupiedHigh;  ///< index space: outside this box the extinction is 0
    bool dense;                      ///< some fine cell may promise more collisions than kVoxelMajorantDepth
};

struct FlatCamera {
    dvec3 eye;                 ///< index space
    dvec3 forward, right, up;  ///< local; `forward` is a unit vector, `right` and `up` are what one image width and
                               ///< height add to it (perspective) or to the eye (orthographic, mm)
    double perspective;        ///< 1 or 0
    ivec2 film;                ///< pixels
    dvec2 perPixel;            ///< 1 / film
    dvec3 localEye;            ///< local
    dvec3 lensRight, lensUp;   ///< local, mm: along `right` and `up`, as long as the lens' radius
    double focus;              ///< mm along the view: where a lens is sharp; 0: a pinhole
};

enum class LightType : std::uint32_t { directional, rectangle, sphere };

struct FlatLight {
    LightType type;
    vec3 radiance;          ///< or irradiance of a directional light
    vec3 position;          ///< local, mm: centre
    vec3 normal;            ///< unit: to the light (directional) or out of the rectangle's shining side
    vec3 halfU, halfV;      ///< half edges of a rectangle, mm
    float area;             ///< mm^2, of a rectangle
    float radius;           ///< mm, of a sphere
    std::uint32_t visible;  ///< 1: the camera sees it
};

/// A ball around some lights. Nodes stand in depth-first order.
struct FlatLightNode {
    vec3 centre;   ///< local, mm
    float radius;  ///< mm
    int light;     ///< the only one within; -1: those of the nodes from here to `next`
    int next;      ///< the first node that is not within
};

// A GPU is sent again only the tables whose bytes changed (device/gpu/gpu_array.h): padding, which nobody sets, would
// be compared with them.
static_assert(sizeof(OpacityPiece) == 4 * sizeof(float));
static_assert(sizeof(Material) == 3 * sizeof(vec3) + sizeof(float));
static_assert(sizeof(FlatLight) == sizeof(LightType) + 5 * sizeof(vec3) + 2 * sizeof(float) + sizeof(std::uint32_t));
static_assert(sizeof(FlatLightNode) == sizeof(vec3) + sizeof(float) + 2 * sizeof(int));

/// Light from all around; see kernel/environment.h. Without a picture `texels` is null.
struct FlatEnvironment {
    vec3 zenith, nadir;       ///< radiance from straight above (+z) and below; a picture is multiplied by zenith
    bool visible;             ///< whether the camera sees it
    float turn;               ///< whole turns: the picture is turned by this from +y towards +x
    ivec2 size;               ///< texels
    const vec3* texels;       ///< radiance, rows from the zenith
    const float* pdf;         ///< of each texel's directions when sampled by its light [1/sr]
    const float* rowSums;     ///< size.y + 1: light of the rows above
    const float* columnSums;  ///< size.x + 1 for each row: light of the texels to the left
};

/// The half space dot(normal, p) <= offset stays; index space.
struct FlatPlane {
    vec3 normal;
    float offset;
};
static_assert(sizeof(FlatPlane) == sizeof(vec3) + sizeof(float));  // sent like the tables above

struct FlatClip {
    const FlatPlane* planes;
    int count;
    bool shadows;  ///< what is cut away still throws its shadow
};

/// For each block of kViewBlock x kViewBlock pixels: the depths along the view between which all lies that is not
/// empty.
struct FlatViewBounds {
    const vec2* depths;  ///< (near, far) mm from the eye along `forward`; near > far: nothing there
    int blocksPerRow;
};
inline constexpr int kViewBlock = 4;

/// The optical models as the kernel tells them apart. All but scattering are sums along one straight ray.
enum class FlatModel : std::uint32_t { scattering, absorption, emission, emissionAbsorption, maximumIntensity };

/// The columns of FlatOptics::table. Along a piece the HU are counted as a fraction, 0 at its start and 1 at its end.
enum class OpticsColumn : int {
    start,           ///< HU; -infinity for the first piece
    end,             ///< HU; infinity for the last piece
    perHu,           ///< fraction per HU; 0 for the outermost pieces, which are constant
    extinction,      ///< at the start [1/mm]
    extinctionRise,  ///< from the start to the end
    source,          ///< radiance per optical depth (albedo + emission) at the start: three columns
    sourceRise = source + 3
};
inline constexpr int kOpticsColumns = int(OpticsColumn::sourceRise) + 3;

/// What the models without scattering look up.
struct FlatOptics {
    FlatModel model;
    const float* table;           ///< kOpticsColumns columns of `stride` entries, one per piece of the curve
    int stride;                   ///< pieces, rounded up to a multiple of kLanes
    float clearUpTo, clearFrom;   ///< HU below the one, and at or above the other, have no extinction
    float rounding;               ///< HU: by how much interpolation in single precision may be off
    float quadrature;             ///< fraction of a ray's radiance that the sum along it may be off
    float cutOff;                 ///< fraction of a ray's radiance that may be left out at its end
    vec3 brightest;               ///< no source and nothing behind the volume is brighter
    float windowLow, windowHigh;  ///< HU shown black and white by maximumIntensity
};

struct SobolTable;

struct FlatScene {
    FlatVolume volume;
    FlatMask mask;
    FlatTransferFunction transferFunction;
    FlatMajorants majorants;
    FlatOptics optics;
    FlatCamera camera;
    FlatViewBounds viewBounds;
    const FlatLight* lights;
    int lightCount;
    const float* lightSums;           ///< lightCount + 1: what the lights before bring; null: few lights
    const FlatLightNode* lightNodes;  ///< where there are sums: of the lights with a place
    int lightNodeCount;
    bool lightsInView;      ///< the camera sees one of them
    bool sampleDirections;  ///< events look for light also where they scatter it to; see directLight()
    bool lightAlongPath;    ///< and there a path that goes on collects it itself; see continuationFindsLight()
    bool plainBackground;   ///< behind the volume it looks the same everywhere
    bool lit;               ///< scattered light may come from somewhere: a light shines, or tissue does
    FlatEnvironment environment;
    FlatClip clip;
    bool fastFiltering;  ///< a device that has texture units may read the volume through them
    bool unshadowed;     ///< light reaches every event as if nothing were in between; see Scene
    bool marched;        ///< by kernel/kroes_path.h instead of kernel/integrator.h: BIASED
    int maxBounces;      ///< scattering events on a path, at most
    float phaseG;
    float surfaceFactor;  ///< see surfaceNormal() [mm/HU]; 0: no surfaces
    std::uint64_t seed;
    const SobolTable* sobol;  ///< kernel/sobol.h
    std::uint32_t features;   ///< kernel/features.h
};

}  // namespace pdr
