#include "render/denoise/guided.h"

#include <algorithm>
#include <cmath>

namespace pdr::denoise {
namespace {

constexpr int kSmooth = 4;            ///< radius in coarse pixels in which pixels share their light
constexpr int kSharpen = 2;           ///< radius in coarse pixels around a pixel of the guide
constexpr float kNormalApart = 0.3f;  ///< normals that differ by so much have half the weight
constexpr float kLeastGuide = 1e-30f;
static_assert(kSmooth <= Plane::kBorder);

/// Returns the means of `factor` x `factor` pixels.
Plane reduced(const Plane& plane, int factor) {
    const ivec2 size = plane.size() / factor;
    Plane out(size);
    for (int y = 0; y < factor * size.y; ++y)
        for (int x = 0; x < factor * size.x; ++x)
            out.row(y / factor)[x / factor] += plane.row(y)[x];
    const float share = 1.0f / float(factor * factor);
    return combined([share](float sum) { return share * sum; }, out);
}

Colours reduced(const Colours& colours, int factor) {
    return {reduced(colours[0], factor), reduced(colours[1], factor), reduced(colours[2], factor)};
}

vec3 at(const Colours& colours, int x, int y) {
    return {colours[0].row(y)[x], colours[1].row(y)[x], colours[2].row(y)[x]};
}

void set(Colours& colours, int x, int y, vec3 value) {
    for (int c = 0; c < 3; ++c)
        colours[c].row(y)[x] = value[c];
}

/// The properties by which two pixels are compared.
struct Surfaces {
    Colours normal;
    Plane depth;
};

/// Returns the surfaces of the coarse image. The depth is averaged over non-empty pixels alone, weighted by opacity.
Surfaces coarseSurfaces(const Guide& guide) {
    const Plane weighted =
        combined([](float depth, float opacity) { return depth * opacity; }, guide.depth, guide.opacity);
    const Plane depth = combined([](float sum, float opacity) { return opacity > 0 ? sum / opacity : 0; },
                                 reduced(weighted, guide.finer), reduced(guide.opacity, guide.finer));
    return {reduced(guide.normal, guide.finer), depth};
}

/// The light on the guide as a quotient lit / unlit, whose parts can be averaged.
struct Light {
    vec3 lit{0.0f}, unlit{0.0f};
};

class LightOnSurfaces {
  public:
    LightOnSurfaces(const Colours& lit, const Colours& unlit, const Surfaces& surfaces)
        : lit_(lit), unlit_(unlit), surfaces_(surfaces) {}

    /// Returns the mean light around a place of the coarse image, weighted by how similar each pixel is to that normal
    /// and depth.
    Light around(vec2 place, vec3 normal, float depth, int radius) const {
        const ivec2 corner(glm::floor(place));
        const float perRadius = 1.0f / float(radius * radius);
        Light sum;
        float total = 0;
        for (int y = corner.y - radius + 1; y <= corner.y + radius; ++y)
            for (int x = corner.x - radius + 1; x <= corner.x + radius; ++x) {
                const vec2 apart = place - vec2(x, y);
                const float near = 1 - perRadius * glm::dot(apart, apart);
                if (near <= 0)
                    continue;
                const float weight = near * near * likeness(x, y, normal, depth);
                sum.lit += weight * at(lit_, x, y);
                sum.unlit += weight * at(unlit_, x, y);
                total += weight;
            }
        return {sum.lit / total, sum.unlit / total};
    }

  private:
    float likeness(int x, int y, vec3 normal, float depth) const {
        const vec3 turned = (at(surfaces_.normal, x, y) - normal) * (1 / kNormalApart);
        const float behind = surfaces_.depth.row(y)[x] - depth;
        return 1 / ((1 + glm::dot(turned, turned)) * (1 + behind * behind));
    }

    const Colours &lit_, &unlit_;
    const Surfaces& surfaces_;
};

}  // namespace

Guide guideOf(ivec2 coarseSize, int finer) {
    const ivec2 size = finer * coarseSize;
    return {finer, coloursOf(size), coloursOf(size), Plane(size), Plane(size)};
}

Colours guided(const Colours& coarse, const Guide& guide) {
    const ivec2 coarseSize = coarse[0].size(), size = guide.depth.size();
    // Average the light among coarse pixels of similar surfaces
    const Surfaces surfaces = coarseSurfaces(guide);
    const Colours unlit = reduced(guide.radiance, guide.finer);
    Colours calmLit = coloursOf(coarseSize), calmUnlit = coloursOf(coarseSize);
    const LightOnSurfaces noisy(coarse, unlit, surfaces);
    eachBand(coarseSize.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < coarseSize.x; ++x) {
                const Light light = noisy.around({x, y}, at(surfaces.normal, x, y), surfaces.depth.row(y)[x], kSmooth);
                set(calmLit, x, y, light.lit);
                set(calmUnlit, x, y, light.unlit);
            }
    });
    for (int c = 0; c < 3; ++c) {
        calmLit[c].mirror();
        calmUnlit[c].mirror();
    }
    // Upsample the light to the guide
    const LightOnSurfaces calm(calmLit, calmUnlit, surfaces);
    Colours out = coloursOf(size);
    eachBand(size.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x) {
                const vec3 radiance = at(guide.radiance, x, y);
                if (radiance == vec3(0))
                    continue;
                const vec2 place = (vec2(x, y) + 0.5f) / float(guide.finer) - 0.5f;
                const Light light = calm.around(place, at(guide.normal, x, y), guide.depth.row(y)[x], kSharpen);
                set(out, x, y, radiance * light.lit / glm::max(light.unlit, kLeastGuide));
            }
    });
    return out;
}

}  // namespace pdr::denoise
