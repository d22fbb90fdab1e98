#include "app/selftest/scene.h"

#include <algorithm>
#include <cmath>

#include "app/selftest/verdict.h"

namespace pdr::selftest {

namespace {

constexpr int kSlabLayers = 24;       ///< voxels through a slab; its rays cross borders of fine and of coarse cells
constexpr int kBedLayers = 4;         ///< voxels through the bed
constexpr float kBedHu = 1000;        ///< HU of the bed; the slab has 0 HU, and the border lies half-way
constexpr double kBedDepth = 40;      ///< optical depth of the bed
constexpr double kSlabWidth = 20000;  ///< width of a slab in thicknesses
constexpr int kRampSteps = 64;        ///< voxels from a ramp's bottom to its top
constexpr int kRampHu = 100;          ///< HU from one voxel to the next
constexpr double kRampTop = kRampSteps * kRampHu;
constexpr double kRampFoot = 1e-3;  ///< HU just above those of the lowest half voxel
constexpr int kRadiusVoxels = 60;   ///< voxels along a sphere's radius
constexpr int kRadiusHu = 200;      ///< HU per voxel of distance from a sphere's centre
constexpr int kSurfaceLayers = 8;   ///< voxels through the medium below a surface, and as many above it
constexpr int kSurfaceHu = 256;     ///< HU per voxel of depth
constexpr double kPlate = 1e-3;     ///< thickness of a plate with a slit, in half widths of the slit
constexpr double kLensFar = 1000;   ///< distance from the lens to the plate, in half widths of the slit
constexpr ivec2 kFilm(64, 64);
constexpr int kMostEvents = 100000;  ///< limit of events on a path; the deepest white slab needs some thousands

/// Makes a volume with the values hu(i, j, k) whose box is centred at the origin.
template <class Hu>
std::shared_ptr<const Volume> makeVolume(ivec3 size, dvec3 spacing, Hu&& hu) {
    Voxels voxels;
    voxels.reserve(std::size_t(size.x) * size.y * size.z);
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                voxels.push_back(std::int16_t(hu(i, j, k)));
    return std::make_shared<Volume>(VolumeGeometry::aligned(size, spacing, -0.5 * spacing * dvec3(size - 1)),
                                    std::move(voxels));
}

TransferNode node(const CaseScene& scene, double hu, double opacity) {
    return {.hu = float(hu),
            .opacity = float(opacity),
            .albedo = vec3(float(scene.albedo)),
            .emission = vec3(float(scene.emission)),
            .specular = vec3(float(scene.specular)),
            .roughness = float(scene.roughness)};
}

/// Returns the upward direction at `cosine` to the vertical, tilted towards `side`.
dvec3 tilted(double cosine, dvec3 side) {
    return side * std::sqrt(1 - cosine * cosine) + dvec3(0, 0, cosine);
}

struct Medium {
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    double top, floor;  ///< heights of the medium's surface and of the position of a camera inside [mm]
};

Medium slab(const CaseScene& scene) {
    const double thickness = extentMm(scene), layer = thickness / kSlabLayers;
    const double side = thickness * kSlabWidth / kSlabLayers;
    const int bed = scene.bed ? kBedLayers : 0;
    const double bedExtinction = scene.bed ? kBedDepth / (kBedLayers * layer) : 0;
    const double densest = std::max(scene.extinctionPerMm, bedExtinction);
    const double opacity = scene.extinctionPerMm / densest;
    Medium medium;
    medium.volume = makeVolume({kSlabLayers, kSlabLayers, kSlabLayers + bed}, {side, side, layer},
                               [&](int, int, int k) { return k < bed ? kBedHu : 0; });
    medium.function.extinctionPerMm = float(densest);
    medium.function.nodes = {node(scene, 0, opacity)};
    if (scene.bed) {
        medium.function.nodes.push_back(node(scene, kBedHu / 2, opacity));
        medium.function.nodes.push_back({.hu = kBedHu / 2, .opacity = 1, .albedo = vec3(0)});
    }
    medium.top = 0.5 * (kSlabLayers + bed) * layer;
    medium.floor = medium.top - thickness;
    return medium;
}

/// Makes a sphere. Its border lies where the interpolated distance from the centre is the radius, so it is round to
/// (voxel / radius)^2 / 6.
Medium sphere(const CaseScene& scene) {
    const double radius = extentMm(scene), voxel = radius / kRadiusVoxels;
    const int half = kRadiusVoxels + 4;
    const double border = kRadiusVoxels * kRadiusHu;
    Medium medium;
    medium.volume = makeVolume(ivec3(2 * half + 1), dvec3(voxel), [&](int i, int j, int k) {
        return std::lround(kRadiusHu * glm::length(dvec3(i - half, j - half, k - half)));
    });
    medium.function.extinctionPerMm = float(scene.extinctionPerMm);
    medium.function.nodes = {node(scene, 0, 1), node(scene, border, 1), node(scene, border, 0)};
    medium.top = radius;
    medium.floor = -radius;
    return medium;
}

/// Makes a ramp from the centres of the lowest to those of the highest voxels; below and above them the volume is
/// empty.
Medium ramp(const CaseScene& scene) {
    const double length = extentMm(scene), step = length / kRampSteps;
    const double side = length * kSlabWidth / kSlabLayers, densest = std::max(1.0, scene.endRatio);
    Medium medium;
    medium.volume = makeVolume({kSlabLayers, kSlabLayers, kRampSteps + 1}, {side, side, step},
                               [](int, int, int k) { return k * kRampHu; });
    medium.function.extinctionPerMm = float(scene.extinctionPerMm * densest);
    medium.function.nodes = {node(scene, kRampFoot, 0), node(scene, kRampFoot, 1 / densest),
                             node(scene, kRampTop, scene.endRatio / densest), node(scene, kRampTop, 0)};
    medium.top = length / 2;
    medium.floor = -length / 2;
    return medium;
}

/// Makes a surface. HU change by the same amount from voxel to voxel everywhere, so every event near the border has the
/// same gradient.
Medium surface(const CaseScene& scene) {
    const double thickness = extentMm(scene), layer = thickness / kSurfaceLayers;
    const double side = thickness * kSlabWidth / kSlabLayers, border = kSurfaceHu / 2.0;
    Medium medium;
    medium.volume = makeVolume({kSlabLayers, kSlabLayers, 2 * kSurfaceLayers}, {side, side, layer},
                               [](int, int, int k) { return kSurfaceHu * (kSurfaceLayers - k); });
    medium.function.extinctionPerMm = float(scene.extinctionPerMm);
    medium.function.nodes = {node(scene, border, 0), node(scene, border, 1)};
    medium.top = 0;
    medium.floor = -thickness;
    return medium;
}

/// Makes a plate with a slit. The two voxels in the middle are open; the plate begins half-way to the next ones.
Medium slit(const CaseScene& scene) {
    constexpr int kWidth = 16;
    const double half = extentMm(scene);
    Medium medium;
    medium.volume = makeVolume({kWidth, kWidth, 2}, {half, half, kPlate * half / 2},
                               [](int i, int, int) { return i == kWidth / 2 - 1 || i == kWidth / 2 ? 0 : 1000; });
    medium.function.extinctionPerMm = float(100 / (kPlate * half));
    medium.function.nodes = {node(scene, 500, 0), node(scene, 500, 1)};
    medium.top = kPlate * half / 2;
    medium.floor = -medium.top;
    return medium;
}

Medium mediumOf(const CaseScene& scene) {
    switch (scene.shape) {
        case CaseScene::Shape::slab:
            return slab(scene);
        case CaseScene::Shape::sphere:
            return sphere(scene);
        case CaseScene::Shape::ramp:
            return ramp(scene);
        case CaseScene::Shape::surface:
            return surface(scene);
        case CaseScene::Shape::slit:
            break;
    }
    return slit(scene);
}

/// Returns a lamp of irradiance 1 at `place`, in direction `wi` from there. Spheres and rectangles are 1e5 extents away
/// and so small that their light is parallel to within 1e-5.
Light lampOf(const CaseScene& scene, dvec3 place, dvec3 wi) {
    constexpr double kPi64 = 3.14159265358979323846, kSize = 0.003;  // radius or edge over distance
    const double distance = 1e5 * extentMm(scene);
    const dvec3 centre = place + wi * distance;
    if (scene.lamp == CaseScene::Lamp::sphere)
        return SphereLight{centre, kSize * distance, vec3(float(1 / (kPi64 * kSize * kSize)))};
    if (scene.lamp == CaseScene::Lamp::rectangle)
        return RectangleLight{
            centre, -wi, {0, 1, 0}, kSize * distance, kSize * distance, vec3(float(1 / (kSize * kSize)))};
    return DirectionalLight{-wi, vec3(1)};
}

Environment roomOf(const CaseScene& scene) {
    Environment room{vec3(float(scene.room)), true};
    if (scene.roomKind == CaseScene::Room::gradient)
        room.nadir = vec3(0);
    if (scene.roomKind == CaseScene::Room::sky)
        room.image = std::make_shared<EnvironmentImage>(EnvironmentImage{{1, 2}, {vec3(1), vec3(0)}});
    return room;
}

Camera cameraOf(const Case& reference, const Medium& medium) {
    const CaseScene& scene = reference.scene;
    const double extent = extentMm(scene);
    Camera camera{.type = Camera::Type::orthographic, .up = {1, 0, 0}};
    if (scene.shape == CaseScene::Shape::slit) {
        camera.eyeMm = {0, 0, kLensFar * extent};
        camera.focusMm = 2 * kLensFar * extent;  // half of the lens's width is left at the plate
        camera.apertureMm = 4 * scene.blur * extent;
    } else if (scene.inside) {
        camera.eyeMm = {0, 0, medium.floor};
        camera.targetMm = {0, 0, medium.top};
    } else {
        camera.targetMm = {0, 0, scene.view > 0 ? medium.top : medium.floor};
        camera.eyeMm = camera.targetMm + tilted(scene.view, {0, 1, 0}) * (2 * extent / std::fabs(scene.view));
    }
    const bool disc =
        reference.quantity == Quantity::discTransmittance || reference.quantity == Quantity::escapeProbability;
    camera.heightMm = disc ? extent * kDiscWidth : std::max(extent * 1e-4, 1e-6);  // camera's minimum
    return camera;
}

}  // namespace

double extentMm(const CaseScene& scene) {
    const double mean = scene.shape == CaseScene::Shape::ramp ? (1 + scene.endRatio) / 2 : 1;
    return scene.depth / (scene.extinctionPerMm * mean);
}

Scene sceneOf(const Case& reference) {
    const CaseScene& from = reference.scene;
    Medium medium = mediumOf(from);
    Scene scene;
    scene.volume = std::move(medium.volume);
    scene.transferFunction = std::move(medium.function);
    scene.model = from.multiple ? Model::multipleScattering : Model::singleScattering;
    scene.maxBounces = kMostEvents;
    scene.phaseG = float(from.g);
    scene.gradientFactor = float(from.gradientFactor);
    if (from.beam)
        scene.lights = {
            lampOf(from, {0, 0, *from.beam > 0 ? medium.top : medium.floor}, tilted(*from.beam, {1, 0, 0}))};
    scene.environment = roomOf(from);
    scene.camera = cameraOf(reference, medium);
    scene.film = kFilm;
    return scene;
}

Scene flightScene(const Case& reference, int bin) {
    Scene scene = sceneOf(reference);
    const CaseScene& from = reference.scene;
    const double length = extentMm(from);
    const double first = from.extinctionPerMm, slope = first * (from.endRatio - 1) / length;
    const double densest = scene.transferFunction.extinctionPerMm;
    const auto border = [&](int i) {  // HU where a fraction of i / kFlightBins has collided
        const double q = -std::log1p(-double(i) / kFlightBins);
        return i == kFlightBins ? kRampTop
                                : kRampTop / length * 2 * q / (first + std::sqrt(first * first + 2 * slope * q));
    };
    const auto band = [&](double hu, double emission) {
        TransferNode result = node(from, hu, (first + slope * length * hu / kRampTop) / densest);
        result.emission = vec3(float(emission));
        return result;
    };
    const double low = std::max(border(bin), kRampFoot), high = border(bin + 1);
    const TransferNode below = scene.transferFunction.nodes.front(), above = scene.transferFunction.nodes.back();
    scene.transferFunction.nodes = {below,         band(kRampFoot, 0), band(low, 0),      band(low, 1),
                                    band(high, 1), band(high, 0),      band(kRampTop, 0), above};
    scene.environment = {vec3(bin == kFlightBins - 1 ? 1.0f : 0.0f), true};
    return scene;
}

}  // namespace pdr::selftest
