#include "app/bench/trackers/tracker.h"

#include <algorithm>

#include "render/device/cpu/lane_tracker.h"
#include "render/kernel/baseline/march.h"
#include "render/kernel/transport/camera_ray.h"

namespace pdr::bench {

namespace {

constexpr float kConvergedStep = 0.05f;  ///< step of the converged march, in voxels

struct Marching {
    const FlatScene& scene;
    float step;  ///< step in mm

    template <class Count>
    float operator()(const Ray& ray, const RandomStream& random, Count&) const {
        return marchToCollision(scene, ray, random, step);
    }
    float operator()(const Ray& ray, const RandomStream& random, Work& work) const {
        const MarchEnd end = march(scene, ray, random, step);
        work.fetches += end.samples;
        return end.distance;
    }
};

struct GlobalTracking {
    const FlatScene& scene;
    float majorant;

    template <class Count>
    float operator()(const Ray& ray, const RandomStream& random, Count& count) const {
        return trackGlobal(scene, ray, random, majorant, count);
    }
};

struct SingleLevelTracking {
    const FlatScene& scene;
    SingleLevelGrid grid;

    template <class Count>
    float operator()(const Ray& ray, const RandomStream& random, Count& count) const {
        return grid.track(scene, ray, random, count);
    }
};

/// The renderer's own tracking, one ray at a time.
struct TwoLevelTracking {
    const FlatScene& scene;

    float operator()(const Ray& ray, const RandomStream& random, NoCount&) const {
        return pdr::track<DeltaTracking>(scene, ray, random);
    }
    /// Runs the same loop and counts. A step ends at a border, so the cell of a real collision is counted with the
    /// collision.
    float operator()(const Ray& ray, const RandomStream& random, Work& work) const {
        MajorantTraversal<float, true> flight;
        flight.start(scene.majorants, {ray.origin.x, ray.origin.y, ray.origin.z},
                     {ray.direction.x, ray.direction.y, ray.direction.z}, ray.length, random);
        DeltaTracking<float> rule;
        while (flight.isActive()) {
            const TentativeCollision<float> collision = flight.step(scene);
            if (collision.happened || collision.voxelMajorant)
                work.fetch();
            if (!collision.happened)
                work.cell();
            if (rule.onCollision(flight.t, collision)) {
                work.cell();
                break;
            }
        }
        return rule.result;
    }
};

template <class Way>
class ScalarTracker final : public Tracker {
  public:
    ScalarTracker(std::string name, Way way) : name_(std::move(name)), way_(std::move(way)) {}

    std::string name() const override { return name_; }
    int hits(const RayList& list) override {
        NoCount nothing;
        return walkAll(list, nothing);
    }
    std::optional<Work> work(const RayList& list) override {
        Work work;
        walkAll(list, work);
        return work;
    }

  private:
    template <class Count>
    int walkAll(const RayList& list, Count& count) const {
        int hits = 0;
        for (std::size_t i = 0; i < list.rays.size(); ++i)
            hits += way_(list.rays[i], list.streams[i], count) >= 0;
        return hits;
    }

    std::string name_;
    Way way_;
};

class LaneTracker final : public Tracker {
  public:
    explicit LaneTracker(const FlatScene& scene) : scene_(scene) {}

    std::string name() const override { return "the same, " + std::to_string(kLanes) + " lanes in step"; }
    int hits(const RayList& list) override {
        int hits = 0;
        for (std::size_t first = 0; first < list.rays.size(); first += RayBatch::kCapacity) {
            const std::size_t end = std::min(first + RayBatch::kCapacity, list.rays.size());
            batch_.clear();
            for (std::size_t i = first; i < end; ++i)
                batch_.add(list.rays[i], list.streams[i]);
            batch_.track<DeltaTracking>(scene_);
            for (int i = 0; i < batch_.size(); ++i)
                hits += batch_.result(i) >= 0;
        }
        return hits;
    }
    std::optional<Work> work(const RayList&) override { return std::nullopt; }

  private:
    const FlatScene& scene_;
    RayBatch batch_;
};

template <class Way>
std::unique_ptr<Tracker> scalar(std::string name, Way way) {
    return std::make_unique<ScalarTracker<Way>>(std::move(name), std::move(way));
}

}  // namespace

RayList primaryRays(const FlatScene& scene, int edge) {
    RayList list;
    const vec2 perRay = vec2(scene.camera.film) / float(edge);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            const Random random(scene.seed, std::uint32_t(y * edge + x), 0);
            const vec2 place = (vec2(x, y) + random.stream(Dimension::filter).pair()) * perRay;
            list.rays.push_back(generateCameraRay(scene, place, vec2(0), vec2(0, 1e30f)).ray);
            list.streams.push_back(random.stream(0, BounceDimension::distance));
        }
    return list;
}

std::vector<std::unique_ptr<Tracker>> allTrackers(const PreparedScene& prepared) {
    const FlatScene& scene = prepared.flat;
    const auto& bounds = prepared.majorants->coarse;
    const float highest = std::max(*std::max_element(bounds.begin(), bounds.end()), 1e-30f);
    std::vector<std::unique_ptr<Tracker>> trackers;
    trackers.push_back(
        scalar("march, 3 voxels (biased)", Marching{scene, marchStep(scene.volume, kExposureRenderStep)}));
    trackers.push_back(scalar("march, 0.05 voxels", Marching{scene, marchStep(scene.volume, kConvergedStep)}));
    trackers.push_back(scalar("delta, one global bound", GlobalTracking{scene, highest}));
    trackers.push_back(scalar("delta, cells of 8", SingleLevelTracking{scene, SingleLevelGrid(scene.majorants)}));
    trackers.push_back(scalar("two-level 16/4 (ours)", TwoLevelTracking{scene}));
    trackers.push_back(std::make_unique<LaneTracker>(scene));
    return trackers;
}

}  // namespace pdr::bench
