#pragma once
/// Tissue that both scatters and reflects, seen along one ray: on rotated and sheared grids, through clip planes, in
/// light of every kind. Each scene is made for what it is sensitive to; together they hold every term of the written
/// formulas.

#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/scene/scene.h"

namespace pdr::test {

/// The direction out of the tissue, perpendicular to its surface.
inline const dvec3 kOutwards = glm::normalize(dvec3(0.3, -0.5, 0.8));

/// A direction at `cosine` to outwards, turned about it by `turn` [radians].
inline dvec3 tilted(double cosine, double turn) {
    const dvec3 s = glm::normalize(glm::cross(kOutwards, dvec3(0, 1, 0))), t = glm::cross(kOutwards, s);
    return kOutwards * cosine + (s * std::cos(turn) + t * std::sin(turn)) * std::sqrt(1 - cosine * cosine);
}

/// The curves: HU rise into the tissue.
enum class Curve {
    slope,  ///< opacity grows evenly
    step,   ///< from clear to opaque at 0 HU, and less again deeper down
    bands,  ///< two steps
    fog,    ///< clear nowhere
};

struct HybridScene {
    std::string name;
    dvec3 spacing{1};        ///< mm; the grid is oblique
    double shear = 0;        ///< how far slices drift along their columns, over their distance: a tilted gantry
    double steepness = 200;  ///< HU/mm into the tissue
    Curve curve = Curve::slope;
    float extinctionPerMm = 1;
    float gradientFactor = 1.5f;
    RayOrigin rayOrigin = RayOrigin::event;
    vec3 specular{0.0f};
    float roughness = 0.5f;
    float g = 0;
    double view = 0.7;  ///< cosine of the viewer's direction to outwards
    std::vector<Light> lights{};
    float room = 0;  ///< radiance of the surroundings
    Clip clip{};
    bool twoMaterials = false;         ///< beyond an oblique plane through the surface there is another material
    float otherGradientFactor = 0.5f;  ///< its gradient factor
    bool evenThere = false;            ///< it is as opaque at all HU, and has the shape of its labels
    int samples = 1024;                ///< samples of each of 1024 pixels
    double sees = 0.01;                ///< relative bias that the run must be able to find, in every channel

    Scene scene() const;
};

/// Voxels of a surface through the origin, uneven, whose HU rise by about `steepness` inwards.
/// `shear`: see HybridScene.
inline std::shared_ptr<const Volume> unevenSurface(dvec3 spacing, double steepness, double shear) {
    const ivec3 size = glm::max(ivec3(glm::ceil(dvec3(14) / spacing)), ivec3(4));
    const dmat4 turned = glm::rotate(dmat4(1), 0.7, glm::normalize(dvec3(1, 2, -0.5)));
    dmat4 map = glm::scale(turned, spacing);
    map[2] += shear * spacing.z * turned[1];
    map[3] = map * dvec4(-0.5 * dvec3(size - 1) + 0.13, 1);
    Voxels voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const dvec3 p(map * dvec4(i, j, k, 1));
                const double waves = std::sin(0.9 * p.x + 1) + std::cos(0.7 * p.y) + std::sin(0.5 * p.z - 1);
                voxels.push_back(std::int16_t(steepness * (0.25 * waves - glm::dot(kOutwards, p))));
            }
    return std::make_shared<Volume>(VolumeGeometry{size, map}, std::move(voxels));
}

/// Labels the voxels of a volume on one side of an oblique plane, which lies near the origin.
inline std::shared_ptr<const LabelMap> beyondAPlane(const Volume& volume) {
    auto map = std::make_shared<LabelMap>();
    map->geometry = volume.geometry();
    map->parts.resize(1);
    const ivec3 size = volume.size();
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const dvec3 place(map->geometry.patientFromIndex * dvec4(i, j, k, 1));
                map->labels.push_back(glm::dot(place, tilted(0.3, 1.2)) > 0.2);
            }
    return map;
}

inline std::vector<TransferNode> nodesOf(const HybridScene& from) {
    const TransferNode clear{.hu = 0, .opacity = 0, .albedo = {0.9f, 0.6f, 0.3f}};
    const auto dense = [&](float hu, float opacity, float fade) {
        return TransferNode{.hu = hu,
                            .opacity = opacity,
                            .albedo = vec3(0.8f, 0.5f, 0.6f) * fade,
                            .specular = from.specular * fade,
                            .roughness = from.roughness * fade};
    };
    switch (from.curve) {
        case Curve::slope:
            return {clear, dense(500, 1, 1), dense(1200, 0.6f, 0.9f)};
        case Curve::step:
            return {clear, dense(0, 1, 1), dense(900, 0.7f, 0.9f)};
        case Curve::bands:
            return {dense(-150, 0, 0.9f), dense(50, 0.4f, 1), dense(50, 0.1f, 0.8f), dense(500, 0.1f, 0.9f),
                    dense(500, 1, 1)};
        case Curve::fog:
            return {dense(-300, 0.2f, 1), dense(500, 1, 0.8f)};
    }
    return {};
}

inline Scene HybridScene::scene() const {
    Scene scene;
    scene.volume = unevenSurface(spacing, steepness, shear);
    scene.transferFunction = {extinctionPerMm, nodesOf(*this)};
    scene.gradientFactor = gradientFactor;
    scene.rayOrigin = rayOrigin;
    scene.phaseG = g;
    scene.lights = lights;
    scene.environment = {vec3(room, 0.8f * room, 0.6f * room), false};
    scene.clip = clip;
    if (twoMaterials) {
        scene.parts.map = beyondAPlane(*scene.volume);
        scene.parts.curves = {{1,
                               {1.7f * extinctionPerMm,
                                {{.hu = -100, .opacity = 0, .albedo = {0.3f, 0.8f, 0.5f}},
                                 {.hu = 150, .opacity = 0.9f, .albedo = {0.2f, 0.9f, 0.6f}, .specular = vec3(0.2f)},
                                 {.hu = 700, .opacity = 0.4f, .albedo = {0.4f, 0.5f, 0.9f}}}},
                               otherGradientFactor}};
        if (evenThere)
            scene.parts.curves[0].transferFunction.nodes = {
                {.hu = 0, .opacity = 0.8f, .albedo = {0.2f, 0.9f, 0.6f}, .specular = vec3(0.2f)}};
    }
    const dvec3 towards = tilted(view, 0.4), target(0.3, -0.2, 0.1);
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = target + towards * 40.0,
                    .targetMm = target,
                    .up = glm::cross(towards, dvec3(1, 0, 0)),
                    .heightMm = 1e-4};
    scene.film = {32, 32};
    return scene;
}

inline Light sun(double cosine, double turn, vec3 irradiance = vec3(2, 2.5f, 3)) {
    return DirectionalLight{-tilted(cosine, turn), irradiance};
}
inline Light ball(double cosine, double turn, double distance, double radius) {
    return SphereLight{tilted(cosine, turn) * distance, radius, {3, 2, 1}};
}
inline Light panel(double cosine, double turn, double distance, double width, double height) {
    const dvec3 towards = tilted(cosine, turn);
    return RectangleLight{
        towards * distance, glm::normalize(dvec3(0.3, 0.1, 0) - towards), {0.2, 0.3, 1}, width, height, {2, 3, 4}};
}

/// The viewer stands at a turn of 0.4: what stands at 0.4 + pi opposite is seen in the gloss.
inline std::vector<HybridScene> hybridScenes() {
    const double facing = 0.4 + M_PI;
    const vec3 enamel(0.04f), metal(0.9f, 0.6f, 0.4f), glaze(0.3f, 0.2f, 0.1f);
    const Clip plane{.planes = {{kOutwards * -1.2, tilted(0.9, 2)}}}, keptShadow{{}, plane.planes, true};
    const Clip box{.box = ClipBox{dvec3(-4, -3.5, -4), dvec3(3, 4, 2)}};
    using enum Curve;
    constexpr RayOrigin outsideEdge = RayOrigin::outsideEdge;
    return {
        {.name = "matt", .gradientFactor = 0.9f, .view = 0.8, .lights = {sun(0.7, 2)}},
        {.name = "matt, unlike spacings", .spacing = {0.3, 0.3, 5}, .gradientFactor = 0.8f, .lights = {sun(0.8, 2)}},
        {.name = "rough gloss", .specular = glaze, .roughness = 0.8f, .lights = {sun(0.6, facing)}},
        {.name = "smooth gloss", .curve = step, .specular = glaze, .roughness = 0.35f, .lights = {sun(0.7, facing)}},
        {.name = "metal",
         .curve = step,
         .gradientFactor = 3,
         .specular = metal,
         .roughness = 0.5f,
         .lights = {sun(0.8, facing)}},
        {.name = "grazing view",
         .curve = step,
         .gradientFactor = 3,
         .specular = enamel,
         .roughness = 0.6f,
         .view = 0.3,
         .lights = {sun(0.95, 1)},
         .samples = 2560,
         .sees = 0.0033},
        {.name = "grazing light",
         .curve = step,
         .specular = enamel,
         .roughness = 0.6f,
         .view = 0.9,
         .lights = {sun(0.35, 1)}},
        {.name = "grazing mirror",
         .curve = step,
         .gradientFactor = 3,
         .specular = enamel,
         .roughness = 0.5f,
         .view = 0.4,
         .lights = {sun(0.45, facing)},
         .samples = 3840,
         .sees = 0.0033},
        {.name = "low gradient factor",
         .gradientFactor = 0.5f,
         .specular = glaze,
         .g = 0.3f,
         .lights = {sun(0.8, facing)}},
        {.name = "flat gradients",
         .steepness = 40,
         .curve = bands,
         .gradientFactor = 1.3f,
         .specular = glaze,
         .lights = {sun(0.8, facing)},
         .samples = 1536},
        {.name = "thin slices",
         .spacing = {0.3, 0.3, 5},
         .specular = glaze,
         .roughness = 0.6f,
         .lights = {sun(0.7, facing)}},
        {.name = "sagittal slices, bands",
         .spacing = {5, 0.3, 0.3},
         .curve = bands,
         .extinctionPerMm = 2,
         .specular = metal,
         .roughness = 0.7f,
         .lights = {sun(0.8, 3)}},
        {.name = "onwards",
         .gradientFactor = 0.7f,
         .specular = enamel,
         .g = 0.7f,
         .view = 0.4,
         .lights = {sun(0.5, facing)}},
        {.name = "backwards, two suns",
         .gradientFactor = 0.8f,
         .specular = glaze,
         .g = -0.5f,
         .lights = {sun(0.8, 1), sun(0.6, facing, vec3(3, 2, 1))},
         .samples = 3072,
         .sees = 0.0033},
        {.name = "cut", .curve = bands, .specular = glaze, .lights = {sun(0.7, 2)}, .clip = plane},
        {.name = "cut, shadow kept",
         .curve = bands,
         .extinctionPerMm = 0.5f,
         .specular = glaze,
         .lights = {sun(0.8, 2)},
         .clip = keptShadow},
        {.name = "boxed, two suns",
         .spacing = {0.7, 1.1, 2},
         .specular = metal,
         .roughness = 0.6f,
         .lights = {sun(0.9, 2), sun(0.7, facing)},
         .clip = box},
        {.name = "ball", .curve = step, .gradientFactor = 3, .lights = {ball(0.7, 2, 12, 6)}},
        {.name = "ball in the gloss",
         .curve = step,
         .gradientFactor = 3,
         .specular = metal,
         .roughness = 0.45f,
         .lights = {ball(0.8, facing, 12, 7)}},
        {.name = "panel in the gloss",
         .curve = step,
         .specular = glaze,
         .roughness = 0.6f,
         .lights = {panel(0.8, facing, 12, 8, 5)}},
        {.name = "ball in fog",
         .steepness = 40,
         .curve = fog,
         .extinctionPerMm = 0.5f,
         .specular = enamel,
         .g = 0.3f,
         .lights = {ball(0.6, facing, 4, 1.8)},
         .samples = 1664},
        {.name = "panel in fog",
         .steepness = 40,
         .curve = fog,
         .extinctionPerMm = 0.25f,
         .specular = enamel,
         .g = -0.3f,
         .lights = {panel(0.95, 2, 4, 4, 3)},
         .samples = 2560},
        {.name = "room, matt", .extinctionPerMm = 0.3f, .gradientFactor = 0.9f, .g = 0.4f, .room = 1},
        {.name = "room, gloss",
         .curve = step,
         .extinctionPerMm = 0.5f,
         .gradientFactor = 3,
         .specular = metal,
         .roughness = 0.7f,
         .room = 1},
        {.name = "outside the edge, oblique",
         .gradientFactor = 3,
         .rayOrigin = outsideEdge,
         .view = 0.5,
         .lights = {sun(0.4, 2)},
         .samples = 2048,
         .sees = 0.003},
        {.name = "outside the edge, gloss",
         .spacing = {0.7, 1.1, 2},
         .curve = step,
         .rayOrigin = outsideEdge,
         .specular = glaze,
         .roughness = 0.6f,
         .lights = {sun(0.6, facing), sun(0.3, 1)}},
        {.name = "outside the edge, grazing",
         .gradientFactor = 3,
         .rayOrigin = outsideEdge,
         .view = 0.3,
         .lights = {sun(0.25, 1)}},
        {.name = "outside the edge, bands",
         .steepness = 100,
         .curve = bands,
         .extinctionPerMm = 3,
         .gradientFactor = 2,
         .rayOrigin = outsideEdge,
         .lights = {sun(0.5, 1)}},
        {.name = "outside the edge, cut",
         .curve = bands,
         .rayOrigin = outsideEdge,
         .specular = glaze,
         .lights = {sun(0.7, 2)},
         .clip = plane},
        {.name = "outside the edge, cut, shadow kept",
         .curve = bands,
         .extinctionPerMm = 0.5f,
         .rayOrigin = outsideEdge,
         .lights = {sun(0.8, 2)},
         .clip = keptShadow},
        {.name = "outside the edge, near panel",
         .curve = step,
         .gradientFactor = 3,
         .rayOrigin = outsideEdge,
         .specular = glaze,
         .roughness = 0.6f,
         .lights = {panel(0.8, facing, 6, 4, 3)}},
        {.name = "outside the edge, near ball in the gloss",
         .curve = step,
         .gradientFactor = 3,
         .rayOrigin = outsideEdge,
         .specular = metal,
         .roughness = 0.45f,
         .lights = {ball(0.8, facing, 9, 5)}},
        {.name = "outside the edge, room",
         .curve = step,
         .extinctionPerMm = 0.5f,
         .gradientFactor = 3,
         .rayOrigin = outsideEdge,
         .specular = metal,
         .roughness = 0.7f,
         .room = 1},
        {.name = "two materials", .lights = {sun(0.7, 2)}, .twoMaterials = true, .samples = 2048, .sees = 0.003},
        {.name = "two materials, unlike spacings",
         .spacing = {0.7, 1.1, 2},
         .curve = step,
         .extinctionPerMm = 0.6f,
         .lights = {sun(0.6, facing), sun(0.8, 2)},
         .twoMaterials = true,
         .samples = 2560,
         .sees = 0.003},
        {.name = "two materials, surface on one side",
         .gradientFactor = 0,
         .g = 0.3f,
         .view = 0.5,
         .lights = {sun(0.5, 2)},
         .twoMaterials = true,
         .otherGradientFactor = 3,
         .samples = 2048,
         .sees = 0.003},
        {.name = "two materials, gloss outside the edge on one side",
         .spacing = {0.7, 1.1, 2},
         .gradientFactor = 0,
         .rayOrigin = outsideEdge,
         .view = 0.5,
         .lights = {sun(0.6, facing)},
         .twoMaterials = true,
         .otherGradientFactor = 3,
         .samples = 3072,
         .sees = 0.003},
        {.name = "two materials, hardly an edge of HU",
         .steepness = 20,
         .curve = fog,
         .gradientFactor = 2,
         .lights = {sun(0.7, 2)},
         .twoMaterials = true,
         .otherGradientFactor = 3,
         .samples = 2048,
         .sees = 0.003},
        {.name = "two materials, one of the shape of its labels",
         .gradientFactor = 2,
         .lights = {sun(0.7, 2)},
         .twoMaterials = true,
         .otherGradientFactor = 3,
         .evenThere = true,
         .samples = 2048,
         .sees = 0.003},
        {.name = "two materials, outside the edge",
         .gradientFactor = 2,
         .rayOrigin = outsideEdge,
         .lights = {sun(0.5, 1)},
         .twoMaterials = true,
         .otherGradientFactor = 3,
         .samples = 2048,
         .sees = 0.003},
    };
}

}  // namespace pdr::test
