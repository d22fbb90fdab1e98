#include "render/device/cpu/projection_batch.h"

#include <bit>
#include <cstring>

namespace pdr {

namespace {

constexpr int kIdleLanes = kLanes / 4;  ///< so many lanes wait before new rays are taken
constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;

/// Lanes read voxels in pairs along x and count them in 32 bits.
bool lanesCanRead(const FlatVolume& volume) {
    const std::int64_t voxels = std::int64_t(volume.size.x) * volume.size.y * volume.size.z;
    return volume.size.x > 1 && voxels <= INT32_MAX;
}

RayResult<float> laneOf(const RayResult<FloatLanes>& lanes, int lane) {
    RayResult<float> one;
    for (int i = 0; i < 3; ++i)
        one.value[i] = lanes.value[i][lane];
    one.left = lanes.left[lane];
    one.exceeded = lanes.exceeded[lane];
    return one;
}

}  // namespace

void ProjectionBatch::add(const Ray& ray, vec3 behind) {
    behind_[size_] = behind;
    origin_.set(size_, ray.origin);
    direction_.set(size_, ray.direction);
    length_[size_] = ray.length;
    ++size_;
}

template <FlatModel Model>
RayWalk<FloatLanes, Model> ProjectionBatch::started(const FlatScene& scene, int row) const {
    const auto loaded = [row](const Column<float>& column) {
        FloatLanes lanes;
        std::memcpy(&lanes, column.data() + row, sizeof lanes);
        return lanes;
    };
    RayWalk<FloatLanes, Model> walk;
    walk.start(scene, {loaded(origin_.x), loaded(origin_.y), loaded(origin_.z)},
               {loaded(direction_.x), loaded(direction_.y), loaded(direction_.z)}, loaded(length_));
    return walk;
}

/// kLanes rays in step. A lane whose ray has ended waits until kIdleLanes do, then they take new rays together.
template <FlatModel Model>
class ProjectionBatch::LaneGroup {
  public:
    LaneGroup(ProjectionBatch& batch, const FlatScene& scene) : batch_(batch), scene_(scene) {}

    /// One step; false when no ray is left. `next`: the first ray of the batch that nobody has taken.
    bool step(int& next) {
        const std::uint32_t idle = laneBits(!walk_.going());
        if (std::popcount(idle) >= kIdleLanes && next < batch_.size_)
            takeRays(idle, next);
        else if (idle == kAllLanes)
            return false;
        walk_.step(scene_);
        return true;
    }

    void keepResults(std::uint32_t lanes) {
        const RayResult<FloatLanes> found = walk_.result();
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (ray_[lane] >= 0)
                batch_.result_[ray_[lane]] = projected<Model>(scene_, laneOf(found, lane), batch_.behind_[ray_[lane]]);
        }
    }

  private:
    void takeRays(std::uint32_t idle, int& next) {
        keepResults(idle);
        while (idle != 0 && next < batch_.size_) {
            const int first = next / kLanes * kLanes;
            if (first != waitingFrom_) {
                waiting_ = batch_.started<Model>(scene_, first);
                waitingFrom_ = first;
            }
            IntLanes fresh{}, from{};
            do {
                const int lane = std::countr_zero(idle);
                idle &= idle - 1;
                fresh[lane] = -1;
                from[lane] = next % kLanes;
                ray_[lane] = next++;
            } while (idle != 0 && next < batch_.size_ && next % kLanes != 0);
            walk_.take(fresh, waiting_, from);
        }
    }

    ProjectionBatch& batch_;
    const FlatScene& scene_;
    RayWalk<FloatLanes, Model> walk_, waiting_;
    int waitingFrom_ = -1;           ///< the ray that lane 0 of waiting_ stands for
    IntLanes ray_ = IntLanes{} - 1;  ///< which ray each lane has; -1: none
};

/// Two groups take turns: while one waits for the memory the other computes.
template <FlatModel Model>
void ProjectionBatch::projectInLanes(const FlatScene& scene) {
    LaneGroup<Model> a(*this, scene), b(*this, scene);
    int next = 0;
    bool going = true;
    while (going) {
        going = a.step(next);
        going = b.step(next) || going;
    }
    a.keepResults(kAllLanes);
    b.keepResults(kAllLanes);
}

template <FlatModel Model>
void ProjectionBatch::project(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        projectInLanes<Model>(scene);
    else
        for (int row = 0; row < size_; ++row)
            result_[row] =
                pdr::project<Model>(scene, {origin_.at(row), direction_.at(row), length_[row]}, behind_[row]);
}

void ProjectionBatch::add(const Origin& origin, const Projected& found, Health& health) {
    if (!addSample(*origin.target, found.radiance))
        health.add(faultOf(found.radiance), origin.sample, origin.pixel);
    if (!found.withinTolerance)
        health.add(Fault::overTolerance, origin.sample, origin.pixel);
}

template <FlatModel Model>
void ProjectionBatch::finish(const FlatScene& scene, Health& health) {
    project<Model>(scene);
    for (int row = 0; row < size_; ++row)
        add(origins_[row], result_[row], health);
    clear();
}

template <FlatModel Model>
void ProjectionBatch::render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const ivec2 pixel(tile.x + x, tile.y + y);
            const vec2 depths = matterDepths(scene, pixel);
            const bool nothing = showsNothing(scene, depths);
            const Projected miss = nothing ? projectedMiss<Model>(scene, backdrop<Model>(scene, Leg{})) : Projected{};
            Origin origin{&sums.pixels[std::ptrdiff_t(y) * sums.stride + x], samples.first,
                          std::uint32_t(pixel.y * scene.camera.film.x + pixel.x)};
            for (std::uint32_t i = 0; i < samples.count; ++i, ++origin.sample) {
                if (nothing) {
                    add(origin, miss, *sums.health);
                    continue;
                }
                if (size_ == kCapacity)
                    finish<Model>(scene, *sums.health);
                const Leg leg = cameraStart(scene, pixel, origin.sample, depths).leg;
                origins_[size_] = origin;
                add(leg.ray, backdrop<Model>(scene, leg));
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
