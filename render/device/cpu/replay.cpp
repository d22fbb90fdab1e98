#include "render/device/cpu/replay.h"

#include "render/device/cpu/sample_origin.h"

namespace pdr {

namespace {

/// All effects are compiled in: those that a scene does not need leave every bit unchanged.
constexpr std::uint32_t kAll = kFeatureMasks - 1;

/// Records what tracePath() reports.
class PathRecorder {
  public:
    PathRecorder(const FlatScene& scene, dvec3 centreMm, std::vector<ReplayedSegment>& segments)
        : scene_(scene), centreMm_(centreMm), segments_(segments) {}

    void segment(const Path& path, int bounce, const Collisions& collisions) {
        path_ = &path;
        const Ray& ray = path.segment.ray;
        ReplayedSegment& segment = segments_.emplace_back();
        segment.startMm = patientPlace(ray.origin);
        segment.direction = path.segment.direction;
        segment.length = ray.length;
        for (int i = 0; i < eventsOn(bounce); ++i)
            segment.events.push_back(eventAfter(collisions.of[i], i, bounce));
    }

    void light(const PathVertex& vertex, const float* transmittances) {
        ReplayedSegment& segment = segments_.back();
        segment.collected = vertex.collected;
        for (std::size_t i = 0; i < segment.events.size(); ++i) {
            ReplayedEvent& event = segment.events[i];
            if (!(event.collision >= 0))
                continue;
            const LightPath& light = vertex.scattered[i];
            event.emitted = vertex.emitted[i];
            event.light = {light.radiance, scene_.volume.localFromIndex * light.ray.direction, light.ray.length,
                           transmittances[i]};
        }
        segment.throughput = path_->throughput;
    }

  private:
    ReplayedEvent eventAfter(float collision, int i, int bounce) const {
        ReplayedEvent event{.collision = collision};
        if (!(collision >= 0))
            return event;
        const vec3 place = path_->segment.ray.origin + path_->segment.ray.direction * collision;
        event.placeMm = patientPlace(place);
        event.hu = hounsfield(scene_.volume, place);
        event.extinction = extinction(scene_, place);
        event.event = eventOf<kAll>(scene_, *path_, i, collision, bounce);
        return event;
    }
    dvec3 patientPlace(vec3 index) const { return dvec3(localPosition(scene_.volume, index)) + centreMm_; }

    const FlatScene& scene_;
    dvec3 centreMm_;
    std::vector<ReplayedSegment>& segments_;
    const Path* path_ = nullptr;
};

}  // namespace

Replay replayed(const PreparedScene& scene, ivec2 pixel, std::uint64_t sample) {
    const FlatScene& flat = scene.flat;
    Replay replay;
    PathRecorder recorder(flat, scene.volume->geometry().centreMm(), replay.segments);
    const PathSample traced = tracePath<kAll>(flat, pixel, sample, depthBounds(flat, pixel), recorder);
    replay.radiance = traced.radiance;
    PixelSums sums;
    SampleOrigin(sums, flat, pixel, sample).add(traced, replay.faults);
    return replay;
}

}  // namespace pdr
