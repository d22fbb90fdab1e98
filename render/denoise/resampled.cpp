#include "render/denoise/resampled.h"

#include <cmath>

namespace pdr::denoise {
namespace {

/// Returns the first of `many` pixels along a line that belongs to part `i` of `few`.
int beginOf(int i, int few, int many) {
    return int(std::int64_t(i) * many / few);
}

/// The place of a pixel's centre on a line of fewer pixels.
struct Place {
    int near;    ///< pixel whose centre is the last before it; -1: none
    float part;  ///< way from there to the next centre, [0, 1)
};

Place placeOf(int i, int few, int many) {
    const float place = (float(i) + 0.5f) * float(few) / float(many) - 0.5f, near = std::floor(place);
    return {int(near), place - near};
}

float between(float a, float b, float part) {
    return a + part * (b - a);
}

}  // namespace

Plane reduced(const Plane& plane, ivec2 size) {
    const ivec2 full = plane.size();
    Plane out(size);
    eachBand(size.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const int top = beginOf(y, size.y, full.y), bottom = beginOf(y + 1, size.y, full.y);
            for (int x = 0; x < size.x; ++x) {
                const int left = beginOf(x, size.x, full.x), right = beginOf(x + 1, size.x, full.x);
                float sum = 0;
                for (int v = top; v < bottom; ++v)
                    for (int u = left; u < right; ++u)
                        sum += plane.row(v)[u];
                out.row(y)[x] = sum / float((right - left) * (bottom - top));
            }
        }
    });
    out.mirror();
    return out;
}

Plane enlarged(const Plane& plane, ivec2 size) {
    const ivec2 few = plane.size();
    std::vector<Place> across;
    across.reserve(std::size_t(size.x));
    for (int x = 0; x < size.x; ++x)
        across.push_back(placeOf(x, few.x, size.x));
    Plane out(size);
    eachBand(size.y, {}, [&](int begin, int end) {
        std::vector<float> line(std::size_t(few.x) + 2);  // from one pixel before the first
        for (int y = begin; y < end; ++y) {
            const Place down = placeOf(y, few.y, size.y);
            const float *upper = plane.row(down.near), *lower = plane.row(down.near + 1);
            for (int x = -1; x <= few.x; ++x)
                line[std::size_t(x) + 1] = between(upper[x], lower[x], down.part);
            for (int x = 0; x < size.x; ++x) {
                const float* near = line.data() + across[std::size_t(x)].near + 1;
                out.row(y)[x] = between(near[0], near[1], across[std::size_t(x)].part);
            }
        }
    });
    out.mirror();
    return out;
}

}  // namespace pdr::denoise
