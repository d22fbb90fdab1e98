#pragma once
/// Runs kernel/transport/integrator.h on the CPU: many paths at a time, each on a segment of its own. A path that ends
/// makes room for the next sample, so that the lanes stay full however long some paths are.

#include <vector>

#include "render/device/cpu/event_group.h"
#include "render/device/cpu/flight_batch.h"
#include "render/device/cpu/lane_tracker.h"
#include "render/device/cpu/sample_origin.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

/// Renders pixels of one scene. Owns the memory for the paths, so each thread has one.
class PixelBatch {
  public:
    /// Adds `samples` to each pixel of `tile`. sums.health must not be null.
    template <std::uint32_t F>
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
        samples_.assign(pixelCount(tile) * samples.count, {});
        std::size_t index = 0;
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x, index += samples.count)
                startPixel<F>(scene, {tile.x + x, tile.y + y}, samples, index);
        while (active_ > 0)
            traceSegments<F>(scene);
        addSamples(scene, tile, samples, sums);
    }

  private:
    /// Starts the samples of a pixel; `index` is the position of the first one in samples_.
    template <std::uint32_t F>
    void startPixel(const FlatScene& scene, ivec2 pixel, SampleRange samples, std::size_t index) {
        const vec2 depths = depthBounds(scene, pixel);
        if (isBackgroundOnly(scene, depths))
            return;
        for (std::uint32_t i = 0; i < samples.count; ++i) {
            while (active_ == RayBatch::kCapacity)
                traceSegments<F>(scene);
            start(scene, pixel, samples.first + i, depths, index + i);
        }
    }

    PDR_HD_INLINE void start(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths,
                             std::size_t index) {
        paths_[active_] = startPath(scene, pixel, sample, depths);
        bounces_[active_] = 0;
        indices_[active_] = index;
        ++active_;
    }

    /// Traces every path to its next event and the light there; paths that continue stay in order.
    template <std::uint32_t F>
    void traceSegments(const FlatScene& scene) {
        traceCollisions(scene);
        lanesCanSeekLight(scene) ? endRowsInLanes<F>(scene) : endRows<F>(scene);
        traceLights(scene);
        keepWhatContinues();
    }

    void traceCollisions(const FlatScene& scene) {
        flights_.clear();
        rays_.clear();
        for (int row = 0; row < active_; ++row) {
            const Path& path = paths_[row];
            if (isFlown(bounces_[row])) {
                depths_[flights_.size()] = eventDepths(scene, path);
                const EventDepths& depths = depths_[flights_.size()];
                flights_.add(path.segment.ray, depths.nearer, depths.further, lookStream(path));
            } else {
                rowOfRay_[rays_.size()] = row;
                rays_.add(path.segment.ray, distanceStream(path, bounces_[row]));
            }
        }
        fly(scene, FlightEnd::places);
        rays_.track<DeltaTracking>(scene);
        for (const int ray : rays_.overMajorant())
            sampleOf(rowOfRay_[ray]).overMajorant = true;
        for (int row = 0, flight = 0, ray = 0; row < active_; ++row)
            collisions_[row] = isFlown(bounces_[row]) ? collisionsOf(flight++) : Collisions{{rays_.result(ray++)}};
        flights_.clear();
        rays_.clear();
    }

    Collisions collisionsOf(int flight) const {
        return depths_[flight].collisions(flights_.distance(flight), flights_.further(flight));
    }

    /// As firstFlight() does.
    void fly(const FlatScene& scene, FlightEnd end) {
        const bool looks = scene.looksAtThin || (end == FlightEnd::whether && scene.lightLooks);
        looks ? flights_.flyByLooks(scene, end) : flights_.fly(scene, end);
    }

    /// Ends all segments as endSegment() does, with as many events at a time as there are lanes.
    template <std::uint32_t F>
    void endRowsInLanes(const FlatScene& scene) {
        collectLight<F>(scene);
        for (int row = 0; row < active_; ++row) {
            continues_[row] = false;
            Event event;
            for (int i = 0; i < eventsOn(bounces_[row]); ++i)
                arriveAt<F>(scene, row, i, event);
        }
        departInLanes<F>(scene);
    }

    /// Gathers event `i` on the segment of a row, if there is one. `event`: the one before, which it may be, too.
    template <std::uint32_t F>
    void arriveAt(const FlatScene& scene, int row, int i, Event& event) {
        const Path& path = paths_[row];
        const int bounce = bounces_[row];
        const float collision = collisions_[row].of[i];
        if (!arrive(scene, path, collision, bounce, sampleOf(row), collected_[row]))
            return;
        if (events_.isFull())
            departInLanes<F>(scene);
        if (i == 0 || eventsApart(scene))
            event = eventOf<F>(scene, path, i, collision, bounce);
        if constexpr (has(F, kBounces))
            if (goesOnFrom(i, bounce))
                onwardNumbers_.set(events_.size(), path.sampler.triple(bounce, BounceDimension::continuation));
        events_.add({row, i}, event, lightNumbers<F>(scene, eventSampler(path, i, bounce), bounce));
    }

    /// Finds the light on all segments.
    template <std::uint32_t F>
    void collectLight(const FlatScene& scene) {
        LaneColumns<LitSegmentOf> segments;
        std::array<int, kLanes> rows;
        int count = 0;
        for (int row = 0; row < active_; ++row) {
            collected_[row] = vec3(0);
            const float collision = collisions_[row].of[0];
            if (collectsLight<F>(scene, bounces_[row], collision)) {
                segments.set(count, litSegment(paths_[row], collision));
                rows[count++] = row;
            }
            if (count < kLanes && (count == 0 || row + 1 < active_))
                continue;
            const LaneColumns<Vec3> lights(lightOnSegment<F>(scene, segments.all()));
            for (int lane = 0; lane < count; ++lane)
                collected_[rows[lane]] = paths_[rows[lane]].throughput * lights.at(lane);
            count = 0;
        }
    }

    /// Finds the light paths from the events that have been gathered, and sends their paths on.
    template <std::uint32_t F>
    void departInLanes(const FlatScene& scene) {
        if (events_.size() == 0)
            return;
        const EventOf<FloatLanes> events = events_.all();
        const LaneColumns<LightPathOf> lights(directLight<F>(scene, events, events_.numbers()));
        for (int lane = 0; lane < events_.size(); ++lane) {
            const auto [row, i] = events_.place(lane);
            addLightPath(row, i, seen(paths_[row], lights.at(lane), bounces_[row]));
            addEmission<F>(paths_[row], events_.emission(lane), bounces_[row], sampleOf(row));
        }
        LaneColumns<ContinuationOf> onward;
        if (has(F, kBounces) && scene.maxBounces > 1)
            onward = LaneColumns<ContinuationOf>(
                continuationFrom<F>(scene, events, onwardNumbers_.all(), scene.lightAlongPath));
        for (int lane = 0; lane < events_.size(); ++lane) {
            const auto [row, i] = events_.place(lane);
            if (!goesOnFrom(i, bounces_[row]))
                continue;
            Path& path = paths_[row];
            const int bounce = bounces_[row];
            PathVertex vertex;
            depart<F>(scene, bounce, sampleOf(row), vertex,
                      [&, lane = lane] { return goOn(path, onward.at(lane), bounce); });
            continues_[row] = vertex.continues;
        }
        events_.clear();
    }

    template <std::uint32_t F>
    void endRows(const FlatScene& scene) {
        for (int row = 0; row < active_; ++row) {
            const PathVertex vertex = endSegment<F>(scene, paths_[row], collisions_[row], bounces_[row], sampleOf(row));
            continues_[row] = vertex.continues;
            for (int i = 0; i < kMostEvents; ++i)
                addLightPath(row, i, vertex.scattered[i]);
        }
    }

    /// Adds the light path from event `i` of a row to those that are traced.
    PDR_HD_INLINE void addLightPath(int row, int i, const LightPath& light) {
        if (isDark(light))
            return;
        const Path& path = paths_[row];
        if (isFlown(bounces_[row])) {
            lightOfFlight_[flights_.size()] = {row, light.radiance};
            flights_.add(light.ray, shadowDepth(path, i), lightLookStream(path, i));
        } else {
            lightOfRay_[rays_.size()] = {row, light.radiance};
            rays_.add(light.ray, shadowStream(path, bounces_[row]));
        }
    }

    void traceLights(const FlatScene& scene) {
        fly(scene, FlightEnd::whether);
        for (int flight = 0; flight < flights_.size(); ++flight)
            addLight(lightOfFlight_[flight], shadowTransmittance(flights_.distance(flight), flights_.passed(flight)));
        rays_.track<RatioTracking>(scene);
        for (const int ray : rays_.overMajorant())
            sampleOf(lightOfRay_[ray].row).overMajorant = true;
        for (int ray = 0; ray < rays_.size(); ++ray)
            addLight(lightOfRay_[ray], rays_.result(ray));
    }

    void keepWhatContinues() {
        int kept = 0;
        for (int row = 0; row < active_; ++row) {
            if (!continues_[row])
                continue;
            if (kept != row)
                paths_[kept] = paths_[row];
            indices_[kept] = indices_[row];
            bounces_[kept++] = bounces_[row] + 1;
        }
        active_ = kept;
    }

    /// Adds the samples in their order, whichever path ended first.
    void addSamples(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) const {
        const vec3 background = plainBackground(scene);
        const PathSample* found = samples_.data();
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x, found += samples.count) {
                const ivec2 pixel(tile.x + x, tile.y + y);
                const vec2 depths = depthBounds(scene, pixel);
                const bool nothing = isBackgroundOnly(scene, depths);
                PixelSums& target = sums.pixels[std::ptrdiff_t(y) * sums.stride + x];
                target.seen |= seenAtFirst(scene, depths);
                SampleOrigin origin(target, scene, pixel, samples.first);
                for (std::uint32_t i = 0; i < samples.count; ++i, ++origin.sample) {
                    if (nothing)
                        origin.add(background, *sums.health);
                    else
                        origin.add(found[i], *sums.health);
                }
            }
    }

    /// Light that may reach the event of a path.
    struct LightOfRow {
        int row;
        vec3 radiance;
    };
    void addLight(const LightOfRow& light, float transmittance) {
        pdr::addLight(sampleOf(light.row), light.radiance, transmittance);
    }
    PathSample& sampleOf(int row) { return samples_[indices_[row]]; }

    std::vector<PathSample> samples_;  ///< samples of the tile: pixel by pixel, row by row
    // for each active path
    int active_ = 0;
    std::array<Path, RayBatch::kCapacity> paths_;
    std::array<int, RayBatch::kCapacity> bounces_;
    std::array<std::size_t, RayBatch::kCapacity> indices_;  ///< positions in samples_
    std::array<bool, RayBatch::kCapacity> continues_;
    std::array<Collisions, RayBatch::kCapacity> collisions_;
    std::array<vec3, RayBatch::kCapacity> collected_;  ///< light on the segment, as the camera sees it
    EventGroup events_;                                ///< events whose light is sought next
    LaneColumns<Vec3> onwardNumbers_;                  ///< and the random numbers for their continuations
    // for each ray: first of segments, then of light paths
    FlightBatch flights_;
    RayBatch rays_;
    static_assert(FlightBatch::kCapacity >= kMostEvents * RayBatch::kCapacity);  // light paths of all paths at once
    std::array<EventDepths, RayBatch::kCapacity> depths_;
    std::array<int, RayBatch::kCapacity> rowOfRay_;
    std::array<LightOfRow, FlightBatch::kCapacity> lightOfFlight_;
    std::array<LightOfRow, RayBatch::kCapacity> lightOfRay_;
};

}  // namespace pdr
