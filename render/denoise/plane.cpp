#include "render/denoise/plane.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pdr::denoise {
namespace {

constexpr int kBandRows = 32;  ///< rows whose numbers stay in a core's cache

/// Adds from[i] to to[i]; the arrays do not overlap.
void add(const float* from, float* __restrict to, int count) {
    for (int i = 0; i < count; ++i)
        to[i] += from[i];
}

}  // namespace

void Plane::mirror() {
    const int width = size_.x, height = size_.y;
    for (int y = 0; y < height; ++y)
        for (int i = 1; i <= kBorder; ++i) {
            row(y)[-i] = row(y)[std::min(i - 1, width - 1)];
            row(y)[width - 1 + i] = row(y)[std::max(width - i, 0)];
        }
    const auto copyRow = [&](int from, int to) {
        std::copy_n(row(from) - kBorder, std::size_t(stride_), row(to) - kBorder);
    };
    for (int i = 1; i <= kBorder; ++i) {
        copyRow(std::min(i - 1, height - 1), -i);
        copyRow(std::max(height - i, 0), height - 1 + i);
    }
}

void eachBand(int height, const std::stop_token& stop, const std::function<void(int, int)>& work) {
    tbb::parallel_for(0, (height + kBandRows - 1) / kBandRows, [&](int band) {
        if (!stop.stop_requested())
            work(band * kBandRows, std::min(height, (band + 1) * kBandRows));
    });
}

Colours coloursOf(ivec2 size) {
    return {Plane(size), Plane(size), Plane(size)};
}

std::size_t bytesOf(const Colours& colours) {
    const auto size = colours[0].size();
    return colours.size() * sizeof(float) * std::size_t(size.x) * std::size_t(size.y);
}

Plane luminance(const Colours& colours) {
    return combined([](float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }, colours[0],
                    colours[1], colours[2]);
}

double meanOf(const Plane& plane) {
    double sum = 0;
    for (int y = 0; y < plane.size().y; ++y)
        for (int x = 0; x < plane.size().x; ++x)
            sum += double(plane.row(y)[x]);
    return sum / (double(plane.size().x) * plane.size().y);
}

Plane boxed(const Plane& plane, int radius) {
    const int width = plane.size().x, height = plane.size().y;
    const float share = 1.0f / float((2 * radius + 1) * (2 * radius + 1));
    Plane across = Plane::unset(plane.size()), out = Plane::unset(plane.size());
    eachBand(height + 2 * radius, {}, [&](int begin, int end) {
        for (int y = begin - radius; y < end - radius; ++y) {
            std::fill_n(across.row(y), width, 0.0f);
            for (int i = -radius; i <= radius; ++i)
                add(plane.row(y) + i, across.row(y), width);
        }
    });
    eachBand(height, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            std::fill_n(out.row(y), width, 0.0f);
            for (int i = -radius; i <= radius; ++i)
                add(across.row(y + i), out.row(y), width);
            for (int x = 0; x < width; ++x)
                out.row(y)[x] *= share;
        }
    });
    out.mirror();
    return out;
}

Plane halved(const Plane& plane, float scale) {
    Plane out = Plane::unset((plane.size() + 1) / 2);
    eachBand(out.size().y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float *upper = plane.row(2 * y), *lower = plane.row(2 * y + 1);
            float* to = out.row(y);
            for (int x = 0; x < out.size().x; ++x)
                to[x] = scale * ((upper[2 * x] + upper[2 * x + 1]) + (lower[2 * x] + lower[2 * x + 1]));
        }
    });
    out.mirror();
    return out;
}

void addDoubled(const Plane& coarse, Plane& fine) {
    eachBand(fine.size().y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const float *near = coarse.row(y / 2), *far = coarse.row(y % 2 == 0 ? y / 2 - 1 : y / 2 + 1);
            float* to = fine.row(y);
            for (int x = 0; x < fine.size().x; ++x) {
                const int i = x / 2, j = x % 2 == 0 ? i - 1 : i + 1;
                to[x] += 0.5625f * near[i] + 0.1875f * (near[j] + far[i]) + 0.0625f * far[j];
            }
        }
    });
    fine.mirror();
}

}  // namespace pdr::denoise
