#include "render/device/cpu/projection_batch.h"

namespace pdr {

namespace {

RayResult<float> laneOf(const RayResult<FloatLanes>& lanes, int lane) {
    RayResult<float> one;
    for (int i = 0; i < 3; ++i)
        one.value[i] = lanes.value[i][lane];
    one.left = lanes.left[lane];
    one.exceeded = lanes.exceeded[lane];
    return one;
}

}  // namespace

/// Presents the batch as a list of rays for walkInLanes().
template <FlatModel Model, Tissue Kind>
struct ProjectionBatch::InLanes {
    using Walk = RayWalk<FloatLanes, Model, Kind>;
    ProjectionBatch& batch;

    int size() const { return batch.size_; }
    Walk started(const FlatScene& scene, int row) const {
        Walk walk;
        walk.start(scene, batch.rays_.origins(row), batch.rays_.directions(row), batch.rays_.lengths(row));
        return walk;
    }
    void keep(const FlatScene& scene, const Walk& walk, int lane, int ray) {
        batch.result_[ray] = projected<Model>(scene, laneOf(walk.result(), lane), batch.behind_[ray]);
    }
};

template <FlatModel Model, Tissue Kind>
void ProjectionBatch::projectInLanes(const FlatScene& scene) {
    InLanes<Model, Kind> rays{*this};
    walkInLanes<RayWalk<FloatLanes, Model, Kind>>(rays, scene);
}

template <FlatModel Model>
void ProjectionBatch::project(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        forProjectedTissue<Model>(scene, [&]<Tissue Kind>() { projectInLanes<Model, Kind>(scene); });
    else
        for (int row = 0; row < size_; ++row)
            result_[row] = pdr::project<Model>(scene, rays_.at(row), behind_[row]);
}

void ProjectionBatch::add(const Ray& ray, vec3 behind) {
    behind_[size_] = behind;
    rays_.set(size_++, ray);
}

template <FlatModel Model>
void ProjectionBatch::finish(const FlatScene& scene, Health& health) {
    project<Model>(scene);
    for (int row = 0; row < size_; ++row)
        origins_[row].add(result_[row], health);
    clear();
}

template <FlatModel Model>
void ProjectionBatch::render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const ivec2 pixel(tile.x + x, tile.y + y);
            const vec2 depths = depthBounds(scene, pixel);
            const bool nothing = isBackgroundOnly(scene, depths);
            const Projected miss =
                nothing ? projectedMiss<Model>(scene, backdrop<Model>(scene, PathSegment{})) : Projected{};
            SampleOrigin origin(sums.pixels[std::ptrdiff_t(y) * sums.stride + x], scene, pixel, samples.first);
            for (std::uint32_t i = 0; i < samples.count; ++i, ++origin.sample) {
                if (nothing) {
                    origin.add(miss, *sums.health);
                    continue;
                }
                if (size_ == kCapacity)
                    finish<Model>(scene, *sums.health);
                const PathSegment segment = startPath(scene, pixel, origin.sample, depths).segment;
                origins_[size_] = origin;
                add(segment.ray, backdrop<Model>(scene, segment));
            }
        }
    finish<Model>(scene, *sums.health);
}

void ProjectionBatch::render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
    switch (scene.optics.model) {
        case FlatModel::absorption:
            return render<FlatModel::absorption>(scene, tile, samples, sums);
        case FlatModel::emission:
            return render<FlatModel::emission>(scene, tile, samples, sums);
        case FlatModel::emissionAbsorption:
            return render<FlatModel::emissionAbsorption>(scene, tile, samples, sums);
        case FlatModel::maximumIntensity:
            return render<FlatModel::maximumIntensity>(scene, tile, samples, sums);
        case FlatModel::scattering:
            return;
    }
}

template void ProjectionBatch::project<FlatModel::absorption>(const FlatScene&);
template void ProjectionBatch::project<FlatModel::emission>(const FlatScene&);
template void ProjectionBatch::project<FlatModel::emissionAbsorption>(const FlatScene&);
template void ProjectionBatch::project<FlatModel::maximumIntensity>(const FlatScene&);

}  // namespace pdr
