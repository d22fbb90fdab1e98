#pragma once
/// The scene as the kernel reads it: plain numbers and pointers into arrays that are owned elsewhere
/// (prepare/flatten.h).
///   index space   voxel (i,j,k) is centred at (i,j,k); the volume's box is [-0.5, size - 0.5]
///   local space   patient axes (LPS), millimetres, origin at the volume's centre
///   along a ray   distances t in mm; a ray's index-space direction is indexFromLocal * (unit local direction)

#include <cstdint>

#include "render/base/portable.h"
#include "render/base/seen.h"

namespace pdr {

/// One linear piece of the transfer function: opacity(hu) = opacity + slope * (hu - start) for hu in [start, end).
struct alignas(16) OpacityPiece {  // aligned, so that a GPU reads it in one access
    float start, end;
    float opacity, slope;
    bool operator==(const OpacityPiece&) const = default;
};

/// Optical properties; meanings as in TransferNode. Real: float, or FloatLanes for those of several places.
template <class Real>
struct MaterialOf {
    glm::vec<3, Real> albedo;
    glm::vec<3, Real> emission;
    glm::vec<3, Real> specular;
    Real roughness;
};
using Material = MaterialOf<float>;

/// A transfer function. pieces[pieceAt[(hu - INT16_MIN) / 16]] is the first piece that may hold hu. The first piece
/// begins below any HU, the last one has no end.
struct FlatTransferFunction {
    const OpacityPiece* pieces;
    const Material* materials;  ///< two per piece: at its start and at its end
    const std::uint16_t* pieceAt;
    int pieceCount;
    float extinctionPerMm;
    int firstPiece;  ///< row of its first piece in FlatOptics::table
    /// [mm/HU], see surfaceFactorOf(); 0: its tissue has no surfaces; below 0: they are where its labels end.
    float surfaceFactor;
};

/// Values on a grid, interpolated trilinearly between its voxels.
struct FlatGrid {
    const std::int16_t* voxels;
    ivec3 size;
    vec3 lastIndex;   ///< size - 1
    vec3 lastCorner;  ///< max(size - 2, 0): lowest corner of the last interpolation cell
    /// Distance to the next voxel along x, y and z in `voxels`; 0 along an axis with a single voxel.
    int stepX;
    std::int64_t stepY, stepZ;
};

struct FlatVolume : FlatGrid {
    dmat3 exactIndexFromLocal;  ///< linear part, 1/mm
    mat3 indexFromLocal;        ///< linear part, 1/mm, in single precision
    mat3 localFromIndex;        ///< linear part, mm
    /// Handle of the GPU texture through which texture units filter the volume (kernel/texture.h); 0: exact filtering.
    std::uint64_t texture;
};

/// The visible part of the volume (volume/mask.h): weights from 0 to kSeen on a grid of their own, whose node (i,j,k)
/// is voxel (i,j,k) << shift. The last node lies on or beyond the last voxel, so that every cell between voxels lies in
/// one cell between nodes. Without a mask `voxels` is null.
struct FlatMask : FlatGrid {
    ivec3 shift;
    vec3 nodesPerVoxel;  ///< 2^-shift
};

/// The curves of parts of the patient (scene/parts.h). At a position the curves of the eight voxels around it are mixed
/// by trilinear interpolation. Without parts `labels` is null.
struct FlatParts {
    const std::uint8_t* labels;      ///< label of each voxel, in the order of the volume's
    const std::uint8_t* materialOf;  ///< 256 entries: the number of each label's curve; 0: the scene's own
    const std::uint8_t* curveOf;     ///< 256 entries: that of the first curve of the same opacity, for all but colours
    const std::uint8_t* onlyCurve;   ///< curveOf all voxels of each fine cell, or kMixedCell
    const FlatTransferFunction* curves;  ///< all curves, the scene's own first
    int curveCount;
    bool colours;  ///< some curves have one opacity
};
/// FlatParts::onlyCurve of a fine cell whose voxels have several curves, or the last of 256.
inline constexpr int kMixedCell = 255;

/// Upper bounds on the extinction [1/mm] in the cells of a two-level grid; volume/ranges.h defines where the cells lie.
struct FlatMajorants {
    const float* fine;
    const float* coarse;
    ivec3 fineSize;
    ivec3 coarseSize;
    vec3 occupiedLow, occupiedHigh;  ///< index space; outside this box the extinction is 0
    bool dense;                      ///< the optical depth of a fine cell may exceed kVoxelMajorantDepth
};

struct FlatCamera {
    dvec3 eye;  ///< index space
    /// Local axes. `forward` is a unit vector; one image width adds `right` and one image height adds `up` to it
    /// (perspective) or to the eye (orthographic, mm).
    dvec3 forward, right, up;
    double perspective;       ///< 1: perspective, 0: orthographic
    ivec2 film;               ///< pixels
    dvec2 perPixel;           ///< 1 / film
    dvec3 localEye;           ///< local space
    dvec3 lensRight, lensUp;  ///< local, mm: along `right` and `up`, as long as the radius of the lens
    double focus;             ///< distance of the plane in focus along the view [mm]; 0: a pinhole
};

enum class LightType : std::uint32_t { directional, rectangle, sphere };

struct FlatLight {
    LightType type;
    vec3 radiance;          ///< radiance, or irradiance of a directional light
    vec3 position;          ///< centre, local [mm]
    vec3 normal;            ///< unit: towards the light (directional) or out of the emitting side of a rectangle
    vec3 halfU, halfV;      ///< half edges of a rectangle [mm]
    float area;             ///< area of a rectangle [mm^2]
    float radius;           ///< radius of a sphere [mm]
    std::uint32_t visible;  ///< 1: the camera sees it
};

/// A node of the tree of lights: a bounding sphere of some lights. Nodes are in depth-first order.
struct FlatLightNode {
    vec3 centre;   ///< local, mm
    float radius;  ///< mm
    int light;     ///< index of the only light inside; -1: the lights of the nodes from here to `next`
    int next;      ///< index of the first node that is not inside this one
};

// Only tables whose bytes changed are sent to a GPU again (device/gpu/gpu_array.h). The structs have no padding, since
// its undefined bytes would be compared, too.
static_assert(sizeof(OpacityPiece) == 4 * sizeof(float));
static_assert(sizeof(Material) == 3 * sizeof(vec3) + sizeof(float));
static_assert(sizeof(FlatLight) == sizeof(LightType) + 5 * sizeof(vec3) + 2 * sizeof(float) + sizeof(std::uint32_t));
static_assert(sizeof(FlatLightNode) == sizeof(vec3) + sizeof(float) + 2 * sizeof(int));
static_assert(sizeof(FlatTransferFunction) == 3 * sizeof(void*) + 2 * sizeof(int) + 2 * sizeof(float));

/// The environment light; see transport/environment.h. Without an image `texels` is null.
struct FlatEnvironment {
    vec3 zenith, nadir;       ///< radiance from straight above (+z) and below; an image is multiplied by zenith
    bool visible;             ///< whether the camera sees the environment
    vec3 behind;              ///< what the camera sees instead if it is not visible
    float turn;               ///< rotation of the image from +y towards +x [whole turns]
    ivec2 size;               ///< texels
    const vec3* texels;       ///< radiance of the texels, rows from the zenith down
    const float* pdf;         ///< pdf of each texel's directions when sampled in proportion to light [1/sr]
    const float* rowSums;     ///< size.y + 1 sums: light of the rows above
    const float* columnSums;  ///< size.x + 1 sums for each row: light of the texels to the left
};

/// A clip plane: keeps the half space dot(normal, p) <= offset in index space.
struct FlatPlane {
    vec3 normal;
    float offset;
};
static_assert(sizeof(FlatPlane) == sizeof(vec3) + sizeof(float));  // compared like the tables above

struct FlatClip {
    const FlatPlane* planes;
    int count;
    bool shadows;  ///< clipped tissue still casts shadows
};

/// Depth bounds for each block of kViewBlock x kViewBlock pixels: all non-empty cells lie between them.
struct FlatViewBounds {
    const vec2* depths;  ///< (near, far) mm from the eye along `forward`; near > far: nothing there
    int blocksPerRow;
};
inline constexpr int kViewBlock = 4;

/// The optical models as the kernel distinguishes them. All except scattering are sums along one straight ray.
enum class FlatModel : std::uint32_t { scattering, absorption, emission, emissionAbsorption, maximumIntensity };

/// The columns of FlatOptics::table. Along a piece, HU are expressed as a fraction: 0 at its start and 1 at its end.
enum class OpticsColumn : int {
    start,           ///< HU; -infinity for the first piece
    end,             ///< HU; infinity for the last piece
    perHu,           ///< fraction per HU; 0 for the outermost pieces, which are constant
    extinction,      ///< extinction at the start [1/mm]
    extinctionRise,  ///< change of the extinction from the start to the end [1/mm]
    source,          ///< three columns: radiance per optical depth (albedo + emission) at the start
    sourceRise = source + 3
};
inline constexpr int kOpticsColumns = int(OpticsColumn::sourceRise) + 3;

/// Tables and constants of the models without scattering.
struct FlatOptics {
    FlatModel model;
    const float* table;           ///< kOpticsColumns columns of `stride` entries, one per piece of each curve
    int stride;                   ///< pieces, rounded up to a multiple of kLanes
    float clearUpTo, clearFrom;   ///< no curve has extinction below clearUpTo and from clearFrom on
    float rounding;               ///< error bound of interpolation in single precision [HU]
    float quadrature;             ///< tolerated error of the sum along a ray, as a fraction of the ray's radiance
    float cutOff;                 ///< fraction of a ray's radiance that may be omitted at its end
    vec3 brightest;               ///< upper bound per channel on the sources, the environment and the background
    float windowLow, windowHigh;  ///< HU shown black and white by maximumIntensity
};

struct SobolTable;

struct FlatScene {
    FlatVolume volume;
    FlatMask mask;
    FlatTransferFunction transferFunction;
    FlatParts parts;
    FlatMajorants majorants;
    FlatOptics optics;
    FlatCamera camera;
    FlatViewBounds viewBounds;
    const FlatLight* lights;
    int lightCount;
    /// lightCount + 1 cumulative sums of picking weights: how much light the lights before bring to the volume; null if
    /// there are few lights.
    const float* lightSums;
    const FlatLightNode* lightNodes;  ///< tree of the rectangles and spheres; only with lightSums
    int lightNodeCount;
    bool lightsInView;      ///< the camera sees at least one of the lights
    bool sampleDirections;  ///< events also sample light along a scattered direction; see directLight()
    bool lightAlongPath;    ///< a path that continues collects that light itself; see continuationFindsLight()
    bool plainBackground;   ///< the background is the same in every direction
    bool lit;               ///< scattered light has a possible source: a light, the environment or tissue
    FlatEnvironment environment;
    FlatClip clip;
    float thinBound;     ///< bound up to which a fine cell is looked at [1/mm]; for a coarse one it is a quarter
    bool looksAtThin;    ///< first flights look at thin tissue (walk/thin_walk.h): the curve shows much of it
    bool lightLooks;     ///< light flies by looks alone (transport/light_flight.h): thin or soft tissue, none dense
    bool fastFiltering;  ///< devices with texture units may read the volume through them
    bool unshadowed;     ///< light reaches every event without attenuation; see Scene
    bool marched;        ///< baseline/kroes_path.h replaces transport/integrator.h: BIASED
    int maxBounces;      ///< maximum number of scattering events on a path
    float phaseG;
    bool raysStartOutside;  ///< rays leave surfaces outside their soft edge; see transport/ray_origin.h
    std::uint64_t seed;
    const SobolTable* sobol;  ///< kernel/sobol.h
    std::uint32_t features;   ///< kernel/features.h
};

}  // namespace pdr
