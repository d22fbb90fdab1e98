#include "render/prepare/flatten.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/kernel/bounds/view_footprint.h"
#include "render/kernel/features.h"
#include "render/kernel/flat_grid.h"
#include "render/kernel/sobol.h"
#include "render/kernel/transport/event.h"
#include "render/kernel/transport/majorant_traversal.h"
#include "render/prepare/flatten_lights.h"
#include "render/prepare/flatten_optics.h"
#include "render/prepare/needs.h"
#include "render/prepare/thin_curve.h"
#include "render/prepare/view_bounds.h"
#include "render/scene/perspective.h"
#include "render/scene/scene.h"

namespace pdr {

namespace {

void flattenVolume(FlatVolume& flat, const Volume& volume) {
    const glm::dmat3 localFromIndex(volume.geometry().patientFromIndex);
    static_cast<FlatGrid&>(flat) = flatGrid(volume.voxels().data(), volume.size());
    flat.exactIndexFromLocal = glm::inverse(localFromIndex);
    flat.indexFromLocal = mat3(flat.exactIndexFromLocal);
    flat.localFromIndex = mat3(localFromIndex);
}

void flattenMask(FlatMask& flat, const Mask& mask) {
    static_cast<FlatGrid&>(flat) = flatGrid(mask.weights().data(), mask.grid().size());
    flat.shift = mask.grid().shift;
    flat.nodesPerVoxel = 1.0f / vec3(ivec3(1) << flat.shift);
}

void flattenMajorants(PreparedScene& prepared) {
    const Majorants& majorants = *prepared.majorants;
    const float highest = *std::max_element(majorants.coarse.begin(), majorants.coarse.end());
    prepared.flat.majorants = {.fine = majorants.fine.data(),
                               .coarse = majorants.coarse.data(),
                               .fineSize = prepared.ranges->fineSize(),
                               .coarseSize = prepared.ranges->coarseSize(),
                               .occupiedLow = majorants.occupiedLow,
                               .occupiedHigh = majorants.occupiedHigh,
                               .dense = mayBeDense(prepared.flat.volume, highest)};
}

void flattenCamera(FlatCamera& flat, const Camera& camera, const VolumeGeometry& geometry, ivec2 film) {
    const double aspect = double(film.x) / film.y;
    const bool perspective = camera.type == Camera::Type::perspective;
    const double height = perspective ? heightPerDepth(camera.fovDegrees) : camera.heightMm;
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

/// Fills in the planes that cut the volume, in index space.
void flattenClip(PreparedScene& prepared, const Scene& scene) {
    const dmat4& patientFromIndex = scene.volume->geometry().patientFromIndex;
    for (const ClipPlane& plane : scene.clip.planesThrough(scene.volume->geometry())) {
        const dvec3 normal = glm::normalize(plane.normal);
        const dvec3 inIndex = glm::transpose(glm::dmat3(patientFromIndex)) * normal;
        const double offset = glm::dot(normal, plane.pointMm - dvec3(patientFromIndex[3]));
        prepared.clipPlanes.push_back({vec3(inIndex), float(offset)});
    }
    prepared.flat.clip = {prepared.clipPlanes.data(), int(prepared.clipPlanes.size()), scene.clip.shadows};
}

bool shines(const std::vector<FlatLight>& lights) {
    return std::ranges::any_of(lights, [](const FlatLight& light) { return light.radiance != vec3(0); });
}

}  // namespace

bool sameMajorants(const PreparedScene& a, const PreparedScene& b) {
    const auto highestHu = [](const PreparedScene& scene) {
        return scene.flat.optics.model == FlatModel::maximumIntensity;
    };
    return a.volume == b.volume && a.mask == b.mask && a.tables.sameOpacity(b.tables) && a.parts.sameOpacity(b.parts) &&
           highestHu(a) == highestHu(b);
}

std::span<const FlatTransferFunction> curvesOf(const PreparedScene& scene) {
    if (scene.parts.empty())
        return {&scene.flat.transferFunction, 1};
    return scene.parts.curves;
}

std::shared_ptr<const PreparedScene> Flattener::prepare(const Scene& scene) {
    std::shared_ptr<PreparedScene> prepared = flattened(scene);
    bound(*prepared);
    last_ = prepared;
    return prepared;
}

std::shared_ptr<const PreparedScene> Flattener::flatten(const Scene& scene) {
    last_ = flattened(scene);
    return last_;
}

std::shared_ptr<PreparedScene> Flattener::flattened(const Scene& scene) const {
    // Flatten the volume, the transfer function and the visible parts.
    auto prepared = std::make_shared<PreparedScene>();
    prepared->revision = scene.revision;
    prepared->volume = scene.volume;
    prepared->tables = TransferTables(scene.transferFunction);
    prepared->flat.transferFunction = prepared->tables.flat();
    prepared->flat.transferFunction.surfaceFactor = surfaceFactorOf(scene.gradientFactor);
    prepared->parts.take(scene, last_ ? &last_->parts : nullptr);
    prepared->flat.parts = prepared->parts.flat();
    flattenVolume(prepared->flat.volume, *scene.volume);
    prepared->seen = {scene.clip.freehand, scene.mask, scene.volume->geometry(), last_ ? &last_->seen : nullptr};
    prepared->mask = prepared->seen.mask();
    if (prepared->mask)
        flattenMask(prepared->flat.mask, *prepared->mask);
    // Reuse the tables of an environment image that is still the same.
    if (scene.environment.image)
        prepared->environment = last_ && last_->environment && last_->environment->image == scene.environment.image
                                    ? last_->environment
                                    : std::make_shared<const EnvironmentTables>(scene.environment.image);
    // Flatten optics, camera, lights and clip planes, which build on the tables above.
    flattenOptics(*prepared, scene);
    flattenCamera(prepared->flat.camera, scene.camera, scene.volume->geometry(), scene.film);
    flattenLights(*prepared, scene);
    flattenClip(*prepared, scene);

    FlatScene& flat = prepared->flat;
    // Set the numbers and flags that select effects in the kernel.
    flat.fastFiltering = scene.filtering == Filtering::fast && !isProjection(scene.model);
    const auto showsThin = [&](const FlatTransferFunction& curve) { return showsThinTissue(curve, flat.volume); };
    const auto showsSoft = [&](const FlatTransferFunction& curve) { return showsSoftTissue(curve, flat.volume); };
    const auto showsDense = [&](const FlatTransferFunction& curve) { return showsDenseTissue(curve, flat.volume); };
    flat.thinBound = thinBound(flat.volume);
    flat.looksAtThin = std::ranges::any_of(curvesOf(*prepared), showsThin);
    // Of one direction the points know all but the looks: there these would bring most of the noise.
    const bool parallel = std::ranges::any_of(
        scene.lights, [](const Light& light) { return std::holds_alternative<DirectionalLight>(light); });
    flat.lightLooks = (flat.looksAtThin || std::ranges::any_of(curvesOf(*prepared), showsSoft)) && !parallel &&
                      std::ranges::none_of(curvesOf(*prepared), showsDense);
    flat.marched = scene.estimator == Estimator::kroesMarch;
    flat.phaseG = scene.phaseG;
    flat.raysStartOutside = scene.rayOrigin == RayOrigin::outsideEdge;
    flat.unshadowed = scene.unshadowed;
    flat.features = neededFeatures(needs(scene));
    flat.maxBounces = has(flat.features, kBounces) ? scene.maxBounces : 1;  // also for kernels that contain all effects
    flat.sampleDirections = searchesAlongScatter(scene);
    // A path does not cross clipped tissue and is attenuated by all other tissue, and so is the light that it collects.
    flat.lightAlongPath = flat.sampleDirections && !flat.unshadowed && !(flat.clip.count > 0 && flat.clip.shadows);
    flat.lit = !isProjection(scene.model) &&
               (shines(prepared->lights) || !scene.environment.isBlack() || (flat.features & kEmission) != 0);
    flat.seed = scene.seed;
    flat.sobol = &kSobolTable;
    return prepared;
}

std::shared_ptr<const Majorants> Flattener::majorantsOf(const PreparedScene& prepared) {
    if (prepared.flat.optics.model != FlatModel::maximumIntensity)
        return edited_.of(prepared);
    return std::make_shared<const Majorants>(highestHu(*prepared.ranges, prepared.volume->size(), prepared.flat.mask));
}

void Flattener::bound(PreparedScene& prepared) {
    const bool sameVolume = last_ && last_->ranges && last_->volume == prepared.volume;
    if (!sameVolume)
        edited_ = {};
    prepared.ranges = sameVolume ? last_->ranges : std::make_shared<const CellRanges>(*prepared.volume);
    prepared.majorants = sameVolume && sameMajorants(*last_, prepared) ? last_->majorants : majorantsOf(prepared);
    flattenMajorants(prepared);
    const bool sameDepths = sameVolume && sameViewDepths(last_->flat, prepared.flat);
    prepared.viewDepths = sameDepths ? last_->viewDepths : viewDepths(prepared.flat);
    prepared.flat.viewBounds = {prepared.viewDepths.data(), viewBlocks(prepared.flat.camera.film).x};
}

}  // namespace pdr
