#include "render/scene/flatten.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/kernel/flight.h"
#include "render/scene/flatten_lights.h"
#include "render/scene/flatten_optics.h"
#include "render/scene/needs.h"
#include "render/scene/view_bounds.h"

namespace pdr {

namespace {

constexpr float kBeyondAnyHu = 1e9f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Material materialOf(const TransferNode& node) {
    return {node.albedo, node.emission, node.specular, node.roughness};
}

void flattenTransferFunction(PreparedScene& prepared, const TransferFunction& function) {
    const std::vector<TransferNode>& nodes = function.nodes;
    const auto add = [&](float start, float end, const TransferNode& from, const TransferNode& to) {
        const float slope = (to.opacity - from.opacity) / (end - start);
        prepared.pieces.push_back(
            {std::max(start, -kBeyondAnyHu), end, from.opacity, std::isfinite(slope) ? slope : 0});
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
    const mat3& step = prepared.flat.volume.localFromIndex;
    const float chord = kFineCell * glm::length(step * vec3(1));  // the diagonal: axes are at right angles
    const float highest = *std::max_element(majorants.coarse.begin(), majorants.coarse.end());
    prepared.flat.majorants = {.fine = majorants.fine.data(),
                               .coarse = majorants.coarse.data(),
                               .fineSize = prepared.ranges->fineSize(),
                               .coarseSize = prepared.ranges->coarseSize(),
                               .occupiedLow = majorants.occupiedLow,
                               .occupiedHigh = majorants.occupiedHigh,
                               .dense = highest * chord > kLookClosely};
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
    flat.localEye = camera.eyeMm - geometry.centreMm();
    const double radius = camera.apertureMm / 2;
    flat.lensRight = camera.right() * radius;
    flat.lensUp = camera.imageUp() * radius;
    flat.focus = radius > 0 ? camera.focusDistanceMm() : 0;
}

/// The planes that cut the volume, in index space; those that leave all of it are left out.
void flattenClip(PreparedScene& prepared, const Scene& scene) {
    const dmat4& patientFromIndex = scene.volume->geometry().patientFromIndex;
    const dvec3 low(-0.5), high = dvec3(scene.volume->size()) - 0.5;
    for (const ClipPlane& plane : scene.clip.allPlanes()) {
        const dvec3 normal = glm::normalize(plane.normal);
        const dvec3 inIndex = glm::transpose(glm::dmat3(patientFromIndex)) * normal;
        const double offset = glm::dot(normal, plane.pointMm - dvec3(patientFromIndex[3]));
        const dvec3 farthest = glm::mix(low, high, glm::greaterThan(inIndex, dvec3(0)));
        const double beyond = glm::dot(inIndex, farthest) - offset;  // mm
        if (beyond > 1e-9 * glm::dot(glm::abs(inIndex), high - low))
            prepared.clipPlanes.push_back({vec3(inIndex), float(offset)});
    }
    prepared.flat.clip = {prepared.clipPlanes.data(), int(prepared.clipPlanes.size()), scene.clip.shadows};
}

/// The HU range over which Kroes, Post & Botha measure the gradient: that of 12-bit CT, so that one metal clip does not
/// change how the rest of the picture looks.
constexpr float kHuScale = 4096;

}  // namespace

std::shared_ptr<const PreparedScene> Flattener::prepare(const Scene& scene) {
    auto prepared = std::make_shared<PreparedScene>();
    const bool sameVolume = last_ && last_->volume == scene.volume;
    const bool highest = scene.model == Model::maximumIntensity;
    const bool sameBounds = sameVolume && last_->transferFunction == scene.transferFunction &&
                            highest == (last_->flat.optics.model == FlatModel::maximumIntensity);
    prepared->revision = scene.revision;
    prepared->volume = scene.volume;
    prepared->transferFunction = scene.transferFunction;
    prepared->ranges = sameVolume ? last_->ranges : std::make_shared<const CellRanges>(*scene.volume);
    prepared->majorants =
        sameBounds ? last_->majorants
        : highest  ? std::make_shared<const Majorants>(highestHu(*prepared->ranges, scene.volume->size()))
                   : std::make_shared<const Majorants>(*prepared->ranges, scene.transferFunction, scene.volume->size());
    flattenVolume(prepared->flat.volume, *scene.volume);
    flattenTransferFunction(*prepared, scene.transferFunction);
    if (scene.environment.image)
        prepared->environment = last_ && last_->environment && last_->environment->image == scene.environment.image
                                    ? last_->environment
                                    : std::make_shared<const EnvironmentTables>(scene.environment.image);
    flattenOptics(*prepared, scene);
    flattenMajorants(*prepared);
    flattenCamera(prepared->flat.camera, scene.camera, scene.volume->geometry(), scene.film);
    flattenLights(*prepared, scene);
    flattenClip(*prepared, scene);

    FlatScene& flat = prepared->flat;
    flat.marched = scene.estimator == Estimator::kroesMarch;
    flat.maxBounces = scene.model == Model::multipleScattering ? scene.maxBounces : 1;
    flat.phaseG = scene.phaseG;
    flat.surfaceFactor = 25 * scene.gradientFactor * scene.gradientFactor * scene.gradientFactor / kHuScale;
    flat.features = neededFeatures(needs(scene));
    flat.sampleDirections = searchesAlongScatter(scene);
    flat.seed = scene.seed;
    prepared->viewDepths = viewDepths(flat);
    flat.viewBounds = {prepared->viewDepths.data(), (scene.film.x + kViewBlock - 1) / kViewBlock};
    last_ = prepared;
    return prepared;
}

}  // namespace pdr
