#pragma once
/// The CPU's way to a guide (denoise/guided.h): each of its pixels is looked at along one ray, at a few depths.

#include <vector>

#include "render/base/tile.h"
#include "render/device/cpu/flight_batch.h"
#include "render/film/display/guided_picture.h"
#include "render/kernel/transport/camera_ray.h"
#include "render/kernel/transport/unshadowed.h"

namespace pdr {

/// Whether a guide shows what films of the scene show: paths that begin in one point and are not marched.
bool canBeGuided(const FlatScene& scene);

/// Owns the room for the rays, so one per thread.
class GuideBatch {
  public:
    /// Looks at the pixels `tile` of the guide of `scene`'s film.
    void look(const FlatScene& scene, const Tile& tile, denoise::Guide& guide);

  private:
    /// On the way into its depth.
    struct Pixel {
        ivec2 place;
        PathSegment segment;
        float reached = 0;     ///< mm from the ray's origin
        float opacity = 0;     ///< of what `seen` knows
        UnshadowedPlace seen;  ///< sums
        UnshadowedPlace last;  ///< where it was looked at last: counts once it is known how far that goes

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
