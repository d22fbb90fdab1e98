#include "render/device/cpu/replay.h"

#include "render/kernel/pixel.h"

namespace pdr {

namespace {

/// With all effects compiled in: those that a scene does not call for leave every bit as it is.
constexpr std::uint32_t kAll = kFeatureMasks - 1;

/// Writes down what tracePath() tells.
class Witness {
  public:
    Witness(const FlatScene& scene, dvec3 centreMm, std::vector<ReplayedLeg>& legs)
        : scene_(scene), centreMm_(centreMm), legs_(legs) {}

    void leg(const Path& path, int bounce, float collision) {
        path_ = &path;
        const Ray& ray = path.leg.ray;
        ReplayedLeg& leg = legs_.emplace_back();
        leg.startMm = patientPlace(ray.origin);
        leg.direction = path.leg.direction;
        leg.length = ray.length;
        leg.collision = collision;
        if (!(collision >= 0))
            return;
        const vec3 place = ray.origin + ray.direction * collision;
        leg.eventMm = patientPlace(place);
        leg.hu = hounsfield(scene_.volume, place);
        leg.extinction = extinction(scene_, place);
        leg.event =
            eventAt<kAll>(scene_, place, path.leg.direction, path.random.stream(bounce, BounceDimension::event));
    }

    void light(const Arrival& met, float transmittance) {
        ReplayedLeg& leg = legs_.back();
        leg.emitted = met.emitted;
        leg.direct = met.scattered.radiance;
        leg.lightDirection = scene_.volume.localFromIndex * met.scattered.ray.direction;
        leg.lightDistance = met.scattered.ray.length;
        leg.transmittance = transmittance;
        leg.throughput = path_->throughput;
    }

  private:
    dvec3 patientPlace(vec3 index) const { return dvec3(localPosition(scene_.volume, index)) + centreMm_; }

    const FlatScene& scene_;
    dvec3 centreMm_;
    std::vector<ReplayedLeg>& legs_;
    const Path* path_ = nullptr;
};

}  // namespace

Replay replayed(const PreparedScene& scene, ivec2 pixel, std::uint64_t sample) {
    const FlatScene& flat = scene.flat;
    const std::uint32_t number = std::uint32_t(pixel.y * flat.camera.film.x + pixel.x);
    Replay replay;
    Witness witness(flat, scene.volume->geometry().centreMm(), replay.legs);
    const Sampled traced = tracePath<kAll>(flat, pixel, sample, matterDepths(flat, pixel), witness);
    replay.radiance = traced.radiance;
    if (PixelSums sums; !addSample(sums, traced.radiance, 0))
        replay.faults.add(faultOf(traced.radiance), sample, number);
    if (traced.overMajorant)
        replay.faults.add(Fault::overMajorant, sample, number);
    if (traced.cut)
        replay.faults.add(Fault::cutPath, sample, number);
    return replay;
}

}  // namespace pdr
