#include "render/device/cpu/lane_tracker.h"

#include <bit>
#include <cstring>

namespace pdr {

Flight<FloatLanes> RayBatch::started(const FlatScene& scene, int row) const {
    const auto load = [row](auto& lanes, const auto& column) {
        std::memcpy(&lanes, column.data() + row, sizeof lanes);
    };
    Vec3<FloatLanes> origin, direction;
    FloatLanes length;
    RandomStreamOf<FloatLanes> random;
    load(origin.x, origin_.x);
    load(origin.y, origin_.y);
    load(origin.z, origin_.z);
    load(direction.x, direction_.x);
    load(direction.y, direction_.y);
    load(direction.z, direction_.z);
    load(length, length_);
    load(random.counter, counter_);
    load(random.key, key_);
    Flight<FloatLanes> flight;
    flight.start(scene.majorants, origin, direction, length, random);
    return flight;
}

/// Lanes read voxels in pairs along x and count them in 32 bits.
static bool lanesCanRead(const FlatVolume& volume) {
    const std::int64_t voxels = std::int64_t(volume.size.x) * volume.size.y * volume.size.z;
    return volume.size.x > 1 && voxels <= INT32_MAX;
}

template <template <class> class Rule>
void RayBatch::track(const FlatScene& scene) {
    if (lanesCanRead(scene.volume))
        trackInLanes<Rule>(scene);
    else
        for (int row = 0; row < size_; ++row) {
            bool over = false;
            result_[row] = pdr::track<Rule>(scene, ray(row), {{counter_[row], key_[row]}}, over);
            if (over)
                overMajorant_.push_back(row);
        }
}

Ray RayBatch::ray(int row) const {
    return {{origin_.x[row], origin_.y[row], origin_.z[row]},
            {direction_.x[row], direction_.y[row], direction_.z[row]},
            length_[row]};
}

/// kLanes rays in step. A lane whose ray has ended waits until kIdleLanes do, then they take new rays together.
template <template <class> class Rule>
class RayBatch::LaneGroup {
  public:
    explicit LaneGroup(RayBatch& batch, const FlatScene& scene) : batch_(batch), scene_(scene) {
        flight_ = waiting_ = batch.started(scene, 0);
        flight_.stop(IntLanes{} - 1);
    }

    /// One step; false when no ray is left. `next`: the first ray of the batch that nobody has taken.
    bool step(int& next) {
        const std::uint32_t idle = laneBits(!flight_.flying());
        if (std::popcount(idle) >= kIdleLanes && next < batch_.size_)
            takeRays(idle, next);
        else if (idle == kAllLanes)
            return false;
        const TentativeCollision<FloatLanes> collision = flight_.step(scene_);
        const IntLanes over = collision.happened & (collision.extinction > collision.majorant);
        if (any(over)) [[unlikely]]
            noteOverMajorant(laneBits(over));
        flight_.stop(rule_.endsAt(flight_.t, collision));
        return true;
    }

    void keepResults(std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (ray_[lane] >= 0)
                batch_.result_[ray_[lane]] = rule_.result[lane];
        }
    }

  private:
    void noteOverMajorant(std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1)
            batch_.overMajorant_.push_back(ray_[std::countr_zero(lanes)]);
    }

    void takeRays(std::uint32_t idle, int& next) {
        keepResults(idle);
        while (idle != 0 && next < batch_.size_) {
            const int first = next / kLanes * kLanes;
            if (first != waitingFrom_) {
                waiting_ = batch_.started(scene_, first);
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
            flight_.take(fresh, waiting_, from);
            rule_.result = fresh ? Rule<FloatLanes>().result : rule_.result;
        }
    }

    RayBatch& batch_;
    const FlatScene& scene_;
    Flight<FloatLanes> flight_, waiting_;
    int waitingFrom_ = 0;  ///< the ray that lane 0 of waiting_ stands for
    Rule<FloatLanes> rule_;
    IntLanes ray_ = IntLanes{} - 1;  ///< which ray each lane has; -1: none
};

/// Two groups take turns: while one waits for the memory the other computes.
template <template <class> class Rule>
void RayBatch::trackInLanes(const FlatScene& scene) {
    LaneGroup<Rule> a(*this, scene), b(*this, scene);
    int next = 0;
    bool flying = true;
    while (flying) {
        flying = a.step(next);
        flying = b.step(next) || flying;
    }
    a.keepResults(kAllLanes);
    b.keepResults(kAllLanes);
}

template void RayBatch::track<DeltaTracking>(const FlatScene& scene);
template void RayBatch::track<RatioTracking>(const FlatScene& scene);

}  // namespace pdr
