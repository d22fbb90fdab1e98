#include "render/denoise/nl_means.h"

#include <algorithm>

namespace pdr::denoise {
namespace {

constexpr int kSearch = 5;         ///< radius of the window
constexpr float kFall = 0.7f;      ///< drop of the window's weight from its middle to its rim
constexpr float kStrength = 0.8f;  ///< standard deviations of the noise that are the unit of distance
constexpr float kCut = 4;          ///< distance from which on the weight is 0
constexpr int kPatch = 2;          ///< radius of a patch
constexpr int kSpread = 1;         ///< radius in which pixels share their weights
constexpr int kReach = kPatch + kSpread;
static_assert(kSearch + kReach <= Plane::kBorder);

/// Returns the weight of the search window, 0 outside of it. The window is round and fades: a square one leaves a
/// cross-hatch.
float windowWeight(int dx, int dy) {
    const float radius = kSearch + 0.5f, squared = float(dx * dx + dy * dy) / (radius * radius);
    return squared > 1 ? 0 : 1 - kFall * squared;
}

/// Returns the weight for a patch's mean distance. A polynomial: the same bits everywhere.
float likeness(float distance) {
    const float rest = std::max(0.0f, 1 - std::max(0.0f, distance) * (1 / kCut));
    return rest * rest * rest;
}

/// Denoises some rows of the image, one neighbour (dx, dy) of all their pixels after the other.
class Band {
  public:
    Band(const NoisyImage& image, Colours& out, int begin, int end)
        : in_(image),
          out_(out),
          begin_(begin),
          rows_(end - begin),
          width_(image.luminance.size().x),
          distances_(std::size_t(width_ + 2 * kReach)),
          likenesses_(std::size_t(width_ + 2 * kSpread)),
          across_(std::size_t(rows_ + 2 * kReach) * likenesses_.size()),
          shared_(std::size_t(rows_ + 2 * kSpread) * std::size_t(width_)),
          total_(std::size_t(rows_) * std::size_t(width_)) {}

    void addNeighbour(int dx, int dy) {
        for (int y = -kReach; y < rows_ + kReach; ++y)
            measure(y, dx, dy);
        for (int y = -kSpread; y < rows_ + kSpread; ++y)
            weigh(y);
        for (int y = 0; y < rows_; ++y)
            add(y, dx, dy);
    }

    /// Divides the sums by their weights.
    void finish() {
        for (int y = 0; y < rows_; ++y)
            for (int c = 0; c < 3; ++c) {
                float* __restrict to = out_[c].row(begin_ + y);
                const float *own = in_.mean[c].row(begin_ + y), *weights = totalRow(y);
                for (int x = 0; x < width_; ++x)
                    to[x] = own[x] + to[x] / weights[x];
            }
    }

  private:
    /// Computes the squared differences less what the noise explains, in units of the noise, summed over the columns of
    /// a patch.
    void measure(int y, int dx, int dy) {
        const float *here = in_.luminance.row(begin_ + y) - kReach, *noiseHere = in_.variance.row(begin_ + y) - kReach;
        const float* there = in_.luminance.row(begin_ + y + dy) - kReach + dx;
        const float* noiseThere = in_.variance.row(begin_ + y + dy) - kReach + dx;
        float* __restrict distances = distances_.data();
        for (int x = 0; x < width_ + 2 * kReach; ++x) {
            const float difference = here[x] - there[x], noise = noiseHere[x] + noiseThere[x];
            distances[x] = (difference * difference - noise) / (kStrength * kStrength * noise);
        }
        const float* d = distances_.data();
        float* __restrict sums = acrossRow(y);
        for (int x = 0; x < width_ + 2 * kSpread; ++x)
            sums[x] = ((d[x] + d[x + 1]) + (d[x + 2] + d[x + 3])) + d[x + 4];
    }

    /// Computes the weights of one row, summed over the columns that share them.
    void weigh(int y) {
        const int wide = width_ + 2 * kSpread;
        const float* s = acrossRow(y - kPatch);
        float* __restrict likenesses = likenesses_.data();
        for (int x = 0; x < wide; ++x) {
            const float sum = ((s[x] + s[x + wide]) + (s[x + 2 * wide] + s[x + 3 * wide])) + s[x + 4 * wide];
            likenesses[x] = likeness(sum * (1.0f / 25));
        }
        const float* l = likenesses_.data();
        float* __restrict sums = sharedRow(y);
        for (int x = 0; x < width_; ++x)
            sums[x] = (l[x] + l[x + 1]) + l[x + 2];
    }

    /// Adds weighted differences, not values: where there is no difference the mean is the pixel itself, to the bit.
    void add(int y, int dx, int dy) {
        const float window = windowWeight(dx, dy);
        const float *upper = sharedRow(y - 1), *middle = sharedRow(y), *lower = sharedRow(y + 1);
        const auto own = [&](int c) { return in_.mean[c].row(begin_ + y); };
        const auto other = [&](int c) { return in_.mean[c].row(begin_ + y + dy) + dx; };
        const float *r = own(0), *g = own(1), *b = own(2), *r2 = other(0), *g2 = other(1), *b2 = other(2);
        float* __restrict red = out_[0].row(begin_ + y), * __restrict green = out_[1].row(begin_ + y);
        float* __restrict blue = out_[2].row(begin_ + y), * __restrict total = totalRow(y);
        for (int x = 0; x < width_; ++x) {
            const float weight = window * ((upper[x] + middle[x]) + lower[x]);
            total[x] += weight;
            red[x] += weight * (r2[x] - r[x]);
            green[x] += weight * (g2[x] - g[x]);
            blue[x] += weight * (b2[x] - b[x]);
        }
    }

    float* acrossRow(int y) { return &across_[std::size_t(y + kReach) * likenesses_.size()]; }
    float* sharedRow(int y) { return &shared_[std::size_t(y + kSpread) * std::size_t(width_)]; }
    float* totalRow(int y) { return &total_[std::size_t(y) * std::size_t(width_)]; }

    const NoisyImage& in_;
    Colours& out_;
    int begin_, rows_, width_;
    std::vector<float> distances_, likenesses_;  ///< values of one row
    std::vector<float> across_, shared_, total_;
};

}  // namespace

Colours nonLocalMeans(const NoisyImage& image, const std::stop_token& stop) {
    const ivec2 size = image.luminance.size();
    Colours out = coloursOf(size);
    eachBand(size.y, stop, [&](int begin, int end) {
        Band band(image, out, begin, end);
        for (int dy = -kSearch; dy <= kSearch && !stop.stop_requested(); ++dy)
            for (int dx = -kSearch; dx <= kSearch; ++dx)
                if (windowWeight(dx, dy) > 0)
                    band.addNeighbour(dx, dy);
        band.finish();
    });
    for (Plane& plane : out)
        plane.mirror();
    return out;
}

}  // namespace pdr::denoise
