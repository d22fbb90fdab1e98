#include "render/denoise/resampled.h"

#include <cmath>

namespace pdr::denoise {
namespace {

/// Returns the first of `many` pixels along a line that belongs to part `i` of `few`.
int beginOf(int i, int few, int many) {
    return int(std::int64_t(i) * many / few);
}

float between(float a, float b, float part) {
    return a + part * (b - a);
}

}  // namespace

Plane reduced(const Plane& plane, ivec2 size) {
    const ivec2 full = plane.size();
    Plane out = Plane::unset(size);
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

EnlargedRows::EnlargedRows(ivec2 few, ivec2 size) : few_(few), size_(size) {
    across_.reserve(std::size_t(size.x));
    for (int x = 0; x < size.x; ++x)
        across_.push_back(placeOf(x, few.x, size.x));
}

EnlargedRows::Place EnlargedRows::placeOf(int i, int few, int many) {
    const float place = (float(i) + 0.5f) * float(few) / float(many) - 0.5f, near = std::floor(place);
    return {int(near), place - near};
}

const float* EnlargedRows::row(const Plane& plane, int y, float* to) const {
    if (few_ == size_)
        return plane.row(y);
    std::vector<float> line(std::size_t(few_.x) + 2);  // from one pixel before the first
    const Place down = placeOf(y, few_.y, size_.y);
    const float *upper = plane.row(down.near), *lower = plane.row(down.near + 1);
    for (int x = -1; x <= few_.x; ++x)
        line[std::size_t(x) + 1] = between(upper[x], lower[x], down.part);
    for (int x = 0; x < size_.x; ++x) {
        const Place place = across_[std::size_t(x)];
        const float* near = line.data() + place.near + 1;
        to[x] = between(near[0], near[1], place.part);
    }
    return to;
}

Plane enlarged(const Plane& plane, ivec2 size) {
    if (plane.size() == size)
        return plane;
    const EnlargedRows rows(plane.size(), size);
    Plane out = Plane::unset(size);
    eachBand(size.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            rows.row(plane, y, out.row(y));
    });
    out.mirror();
    return out;
}

}  // namespace pdr::denoise
