#pragma once
/// A plane: one number for each pixel of an image, with the basic filters. Beyond its edges a plane continues as its
/// mirror image, kBorder pixels far, so that a filter may read there without checks; code that changes pixels must call
/// mirror(). Every sum has a fixed order: the bits depend neither on threads nor on the instruction set of the machine.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/base/portable.h"
#include "render/denoise/plane_memory.h"

namespace pdr::denoise {

class Plane {
  public:
    static constexpr int kBorder = 16;

    Plane() = default;
    /// Creates a plane of zeros; at least 1 x 1.
    explicit Plane(ivec2 size) : Plane(size, 0.0f) {}
    /// Creates a plane whose values are all to be set: the system provides its memory to the threads that set them.
    static Plane unset(ivec2 size) { return Plane(size, std::nullopt); }

    ivec2 size() const { return size_; }
    /// Returns a pointer to pixel (0, y). Both x and y may be up to kBorder outside.
    float* row(int y) { return values_.data() + at(y); }
    const float* row(int y) const { return values_.data() + at(y); }
    void mirror();

  private:
    Plane(ivec2 size, std::optional<float> value)
        : size_(size),
          stride_(size.x + 2 * kBorder),
          values_(std::size_t(stride_) * std::size_t(size.y + 2 * kBorder)) {
        if (value)
            std::ranges::fill(values_, *value);
    }
    std::size_t at(int y) const { return std::size_t(y + kBorder) * std::size_t(stride_) + kBorder; }

    ivec2 size_{0};
    int stride_ = 0;
    std::vector<float, PlaneAllocator<float>> values_;
};

/// The three channels of an image, linear Rec. 709.
using Colours = std::array<Plane, 3>;
Colours coloursOf(ivec2 size);
/// Returns the memory that the pixels take.
std::size_t bytesOf(const Colours& colours);

/// Calls work(first row, row after the last) for bands of some rows each, on many threads; no band begins after a stop
/// request.
void eachBand(int height, const std::stop_token& stop, const std::function<void(int, int)>& work);

/// Returns f(x, y...) of each pixel of planes of one size; computed on many threads.
template <class F, class... Planes>
Plane combined(const F& f, const Plane& first, const Planes&... others) {
    Plane out = Plane::unset(first.size());
    eachBand(out.size().y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < out.size().x; ++x)
                out.row(y)[x] = f(first.row(y)[x], others.row(y)[x]...);
    });
    out.mirror();
    return out;
}

Plane luminance(const Colours& colours);
/// Returns the mean of all pixels.
double meanOf(const Plane& plane);
/// Returns the mean over (2 radius + 1)^2 pixels, radius <= kBorder.
Plane boxed(const Plane& plane, int radius);
/// Returns `scale` times the sum of 2 x 2 pixels, in half the size, rounded up.
Plane halved(const Plane& plane, float scale);
/// Adds `coarse`, which is half as large, with bilinear interpolation.
void addDoubled(const Plane& coarse, Plane& fine);

}  // namespace pdr::denoise
