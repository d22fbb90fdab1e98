#include "render/scene/flatten.h"

#include <cmath>
#include <limits>

#include "render/scene/needs.h"
#include "render/scene/view_bounds.h"

namespace pdr {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Material materialOf(const TransferNode& node) {
    return {node.albedo, node.emission, node.specular, node.roughness};
}

void flattenTransferFunction(PreparedScene& prepared, const TransferFunction& function) {
    const std::vector<TransferNode>& nodes = function.nodes;
    const auto add = [&](float start, float end, const TransferNode& from, const TransferNode& to) {
        const float slope =
            std::isfinite(start) && std::isfinite(end) ? (to.opacity - from.opacity) / (end - start) : 0;
        prepared.pieces.push_back({std::isfinite(start) ? start : 0, end, from.opacity, slope});
        prepared.materials.push_back(materialOf(from));
        prepared.materials.push_back(materialOf(to));
    };
    add(-kInfinity, nodes.front().hu, nodes.front(), nodes.front());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        if (nodes[i].hu < nodes[i + 1].hu)
            add(nodes[i].hu, nodes[i + 1].hu, nodes[i], nodes[i + 1]);
    add(nodes.back().hu, kInfinity, nodes.back(), nodes.back());

    prepared.pieceAt.resize(65536 / 16);
    std::uint16_t piece = 0;
    for (std::size_t bucket = 0; bucket < prepared.pieceAt.size(); ++bucket) {
        // int(hu) rounds towards 0, so a negative bucket reaches one HU below its first whole number.
        const float lowest = float(int(bucket) * 16 - 32768) - 1;
        while (lowest >= prepared.pieces[piece].end)
            ++piece;
        prepared.pieceAt[bucket] = piece;
    }
    prepared.flat.transferFunction = {prepared.pieces.data(), prepared.materials.data(), prepared.pieceAt.data(),
                                      int(prepared.pieces.size()), function.extinctionPerMm};
}

void flattenVolume(FlatVolume& flat, const Volume& volume) {
    const ivec3 size = volume.size();
    const glm::dmat3 localFromIndex(volume.geometry().patientFromIndex);
    flat.voxels = volume.voxels().data();
    flat.size = size;
    flat.lastIndex = vec3(size - 1);
    flat.lastCorner = glm::max(vec3(size - 2), vec3(0));
    flat.stepX = size.x > 1 ? 1 : 0;
    flat.stepY = size.y > 1 ? size.x : 0;
    flat.stepZ = size.z > 1 ? std::int64_t(size.x) * size.y : 0;
    flat.exactIndexFromLocal = glm::inverse(localFromIndex);
    flat.indexFromLocal = mat3(flat.exactIndexFromLocal);
    flat.localFromIndex = mat3(localFromIndex);
}

void flattenMajorants(PreparedScene& prepared) {
    const Majorants& majorants = *prepared.majorants;
    prepared.flat.majorants = {majorants.fine.data(),         majorants.coarse.data(), prepared.ranges->fineSize(),
                               prepared.ranges->coarseSize(), majorants.occupiedLow,   majorants.occupiedHigh};
}

void flattenCamera(FlatCamera& flat, const Camera& camera, const VolumeGeometry& geometry, ivec2 film) {
    const double aspect = double(film.x) / film.y;
    const bool perspective = camera.type == Camera::Type::perspective;
    const double height = perspective ? 2 * std::tan(glm::radians(camera.fovDegrees) / 2) : camera.heightMm;
    flat.eye = dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(camera.eyeMm, 1.0));
    flat.forward = camera.forward();
    flat.right = camera.right() * (height * aspect);
    flat.up = camera.imageUp() * height;
    flat.perspective = perspective ? 1 : 0;
    flat.film = film;
    flat.perPixel = 1.0 / dvec2(film);
}

FlatLight flatLight(const DirectionalLight& light, dvec3) {
    FlatLight flat{.type = LightType::directional, .radiance = light.irradiance};
    flat.normal = vec3(-glm::normalize(light.direction));
    return flat;
}

FlatLight flatLight(const RectangleLight& light, dvec3 centreMm) {
    const dvec3 normal = glm::normalize(light.normal);
    const dvec3 side = glm::normalize(glm::cross(light.up, normal));
    return {.type = LightType::rectangle,
            .radiance = light.radiance,
            .position = vec3(light.centreMm - centreMm),
            .normal = vec3(normal),
            .halfU = vec3(side * (light.widthMm / 2)),
            .halfV = vec3(glm::cross(normal, side) * (light.heightMm / 2)),
            .area = float(light.widthMm * light.heightMm)};
}

FlatLight flatLight(const SphereLight&, dvec3) {
    return {};  // refused by Scene::check()
}

void flattenLights(PreparedScene& prepared, const Scene& scene) {
    const dvec3 centre = scene.volume->geometry().centreMm();
    FlatScene& flat = prepared.flat;
    for (const Light& light : scene.lights)
        prepared.lights.push_back(std::visit([&](const auto& one) { return flatLight(one, centre); }, light));
    flat.environment = scene.environment.radiance;
    flat.environmentVisible = scene.environment.visible ? 1 : 0;
    flat.lights = prepared.lights.data();
    flat.lightCount = int(prepared.lights.size());
}

/// The HU range over which Kroes, Post & Botha measure the gradient: that of 12-bit CT, so that one metal clip does not
/// change how the rest of the picture looks.
constexpr float kHuScale = 4096;

}  // namespace

std::shared_ptr<const PreparedScene> Flattener::prepare(const Scene& scene) {
    auto prepared = std::make_shared<PreparedScene>();
    const bool sameVolume = last_ && last_->volume == scene.volume;
    const bool sameFunction = sameVolume && last_->transferFunction == scene.transferFunction;
    prepared->revision = scene.revision;
    prepared->volume = scene.volume;
    prepared->transferFunction = scene.transferFunction;
    prepared->ranges = sameVolume ? last_->ranges : std::make_shared<const CellRanges>(*scene.volume);
    prepared->majorants = sameFunction ? last_->majorants
                                       : std::make_shared<const Majorants>(*prepared->ranges, scene.transferFunction,
                                                                           scene.volume->size());
    flattenVolume(prepared->flat.volume, *scene.volume);
    flattenTransferFunction(*prepared, scene.transferFunction);
    flattenMajorants(*prepared);
    flattenCamera(prepared->flat.camera, scene.camera, scene.volume->geometry(), scene.film);
    flattenLights(*prepared, scene);

    FlatScene& flat = prepared->flat;
    flat.maxBounces = scene.model == Model::multipleScattering ? scene.maxBounces : 1;
    flat.phaseG = scene.phaseG;
    flat.surfaceFactor = 25 * scene.gradientFactor * scene.gradientFactor * scene.gradientFactor / kHuScale;
    flat.features = neededFeatures(needs(scene));
    flat.seed = scene.seed;
    prepared->viewDepths = viewDepths(flat);
    flat.viewBounds = {prepared->viewDepths.data(), (scene.film.x + kViewBlock - 1) / kViewBlock};
    last_ = prepared;
    return prepared;
}

}  // namespace pdr
