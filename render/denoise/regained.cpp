#include "render/denoise/regained.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pdr::denoise {
namespace {

constexpr int kWays = 16, kReach = 4;  ///< directions; pixels to either side of a line's middle
constexpr int kLength = 2 * kReach + 1, kPixels = 2 * kLength;
constexpr float kMost = 2.5f;  ///< clamp of a pixel's standard deviations: a bright sample alone is no line
constexpr float kLeastZ = 3;   ///< least z of a line that is restored; z = 4 restores two thirds, z = 6 nearly all
static_assert(kReach + 2 <= Plane::kBorder);

/// A direction: the pixels along a line, relative to its middle, and the step to the line beside it.
struct Way {
    std::array<ivec2, kLength> along;
    ivec2 beside{0};
};

/// Returns the directions: half a turn in even steps.
std::array<Way, kWays> ways() {
    std::array<Way, kWays> all;
    for (int index = 0; index < kWays; ++index) {
        const double angle = std::numbers::pi * index / kWays, x = std::cos(angle), y = std::sin(angle);
        const bool steep = std::fabs(y) > std::fabs(x);
        const double stretch = std::max(std::fabs(x), std::fabs(y));
        Way& way = all[std::size_t(index)];
        way.beside = steep ? ivec2(1, 0) : ivec2(0, 1);
        for (int i = 0; i < kLength; ++i)
            way.along[std::size_t(i)] = {int(std::lround((i - kReach) * x / stretch)),
                                         int(std::lround((i - kReach) * y / stretch))};
    }
    return all;
}

/// Returns the luminance that denoising removed, in standard deviations of the noise, clamped to kMost.
Plane takenSigmas(const Plane& raw, const Plane& smooth, const Plane& variance) {
    return combined(
        [](float noisy, float calm, float noise) {
            return noise > 0 ? std::clamp((noisy - calm) / std::sqrt(noise), -kMost, kMost) : 0.0f;
        },
        raw, smooth, variance);
}

/// Finds the clearest line of each pixel in some rows.
class ClearestLines {
  public:
    ClearestLines(const Plane& taken, int begin, int end)
        : taken_(taken),
          begin_(begin),
          rows_(end - begin),
          width_(taken.size().x),
          sums_(std::size_t(rows_ + 2) * std::size_t(width_ + 2)),
          best_(std::size_t(rows_) * std::size_t(width_)),
          sides_(best_.size()) {}

    /// Considers the lines of one more direction: the pixel's line together with the one on either side.
    void look(int index, const Way& way) {
        for (int y = -1; y <= rows_; ++y)
            addUp(y, way);
        for (const int side : {0, 1})
            for (int y = 0; y < rows_; ++y)
                compare(y, 2 * index + side, side == 0 ? way.beside : -way.beside);
    }

    /// Returns the sum along the clearest line in its standard deviations.
    float z(int x, int y) const { return best_[at(x, y - begin_)] / std::sqrt(float(kPixels)); }
    /// Returns twice the direction of the clearest line, plus 1 where its second row lies on the other side.
    int side(int x, int y) const { return sides_[at(x, y - begin_)]; }

  private:
    /// Sums along the direction for one row, with one pixel more on either side.
    void addUp(int y, const Way& way) {
        float* __restrict sums = sumsRow(y) - 1;
        std::fill_n(sums, width_ + 2, 0.0f);
        for (const ivec2 step : way.along) {
            const float* from = taken_.row(begin_ + y + step.y) + step.x - 1;
            for (int x = 0; x < width_ + 2; ++x)
                sums[x] += from[x];
        }
    }

    void compare(int y, int side, ivec2 beside) {
        const float *own = sumsRow(y), *other = sumsRow(y + beside.y) + beside.x;
        float* __restrict best = &best_[at(0, y)];
        int* __restrict sides = &sides_[at(0, y)];
        for (int x = 0; x < width_; ++x) {
            const float sum = own[x] + other[x];
            const bool clearer = std::fabs(sum) > std::fabs(best[x]);
            best[x] = clearer ? sum : best[x];
            sides[x] = clearer ? side : sides[x];
        }
    }

    float* sumsRow(int y) { return &sums_[std::size_t(y + 1) * std::size_t(width_ + 2) + 1]; }
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }

    const Plane& taken_;
    int begin_, rows_, width_;
    std::vector<float> sums_;  ///< sums along the direction that was added last
    std::vector<float> best_;
    std::vector<int> sides_;
};

/// Returns the mean along a line and the one beside it.
float meanAlong(const Plane& plane, int x, int y, const Way& way, ivec2 beside) {
    float sum = 0;
    for (const ivec2 step : way.along) {
        const float* row = plane.row(y + step.y) + x + step.x;
        sum += row[0] + plane.row(y + step.y + beside.y)[x + step.x + beside.x];
    }
    return sum / kPixels;
}

}  // namespace

void regain(const Colours& raw, const Plane& variance, Colours& smooth, const std::stop_token& stop) {
    // Compute what denoising removed
    const Plane taken = takenSigmas(luminance(raw), luminance(smooth), variance);
    Colours lost;
    for (int c = 0; c < 3; ++c)
        lost[c] = combined([](float noisy, float calm) { return noisy - calm; }, raw[c], smooth[c]);
    const std::array<Way, kWays> all = ways();
    eachBand(variance.size().y, stop, [&](int begin, int end) {
        ClearestLines lines(taken, begin, end);
        for (int index = 0; index < kWays && !stop.stop_requested(); ++index)
            lines.look(index, all[std::size_t(index)]);
        // Put back the mean along the clearest line of each pixel
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < variance.size().x; ++x) {
                const float unsure = kLeastZ / std::fabs(lines.z(x, y));
                if (!(unsure < 1))
                    continue;
                const Way& way = all[std::size_t(lines.side(x, y) / 2)];
                const ivec2 beside = lines.side(x, y) % 2 == 0 ? way.beside : -way.beside;
                const float share = 1 - unsure * unsure * unsure * unsure;
                for (int c = 0; c < 3; ++c) {
                    float& shown = smooth[c].row(y)[x];
                    shown = std::max(shown + share * meanAlong(lost[c], x, y, way, beside), 0.0f);
                }
            }
    });
    for (Plane& plane : smooth)
        plane.mirror();
}

}  // namespace pdr::denoise
