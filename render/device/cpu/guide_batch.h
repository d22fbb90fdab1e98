#pragma once
/// Renders guides (denoise/guided.h) on the CPU: one ray for each pixel, evaluated at a few depths.

#include <vector>

#include "render/base/tile.h"
#include "render/device/cpu/flight_batch.h"
#include "render/film/display/enlarged_film.h"
#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/unshadowed.h"

namespace pdr {

/// Returns whether a guide shows what films of the scene show: paths begin in one point and are not marched.
bool canBeGuided(const FlatScene& scene);

/// Renders pixels of a guide. Owns the memory for the rays, so each thread has one.
class GuideBatch {
  public:
    /// Renders the pixels `tile` of the guide of `scene`'s film, each by a ray at `place` in it (denoise::GuideRays).
    void look(const FlatScene& scene, const Tile& tile, vec2 place, denoise::Guide& guide);

  private:
    /// A pixel whose ray is being followed into the depth.
    struct Pixel {
        ivec2 place;
        PathSegment segment;
        float reached = 0;     ///< distance so far [mm from the ray's origin]
        float opacity = 0;     ///< opacity that `seen` covers
        UnshadowedPlace seen;  ///< weighted sums
        UnshadowedPlace last;  ///< last evaluated place: counts once its extent is known

        void settle(float upTo);
        Ray rest() const;
    };

    void finish(const FlatScene& scene, denoise::Guide& guide);
    static void keep(const FlatScene& scene, const Pixel& pixel, denoise::Guide& guide);

    FlightBatch flights_;
    std::vector<Pixel> pixels_;
    std::vector<Pixel*> going_;
};

}  // namespace pdr
