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

    void segment(const Path& path, int bounce, float collision) {
        path_ = &path;
        const Ray& ray = path.segment.ray;
        ReplayedSegment& segment = segments_.emplace_back();
        segment.startMm = patientPlace(ray.origin);
        segment.direction = path.segment.direction;
        segment.length = ray.length;
        segment.collision = collision;
        if (!(collision >= 0))
            return;
        const vec3 place = ray.origin + ray.direction * collision;
        segment.eventMm = patientPlace(place);
        segment.hu = hounsfield(scene_.volume, place);
        segment.extinction = extinction(scene_, place);
        segment.event =
            eventAt<kAll>(scene_, place, -path.segment.direction, path.sampler.number(bounce, BounceDimension::event));
    }

    void light(const PathVertex& vertex, const float* transmittances) {
        ReplayedSegment& segment = segments_.back();
        segment.collected = vertex.collected;
        if (!(segment.collision >= 0))
            return;
        segment.emitted = vertex.emitted;
        const int lightPaths = lightPathsFrom(int(segments_.size()) - 1);
        for (int i = 0; i < lightPaths; ++i) {
            const LightPath& light = vertex.scattered[i];
            segment.lights.push_back({light.radiance, scene_.volume.localFromIndex * light.ray.direction,
                                      light.ray.length, transmittances[i]});
        }
        segment.throughput = path_->throughput;
    }

  private:
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
