#include "render/denoise/nl_means.h"

namespace pdr::denoise {
namespace {

/// Adds weighted differences, not values: where there is no difference the mean is the pixel itself, to the bit. One
/// channel at a time, since a compiler does not put together what reads and writes more arrays.
void addDifferences(const float* weights, const float* own, const float* other, float* __restrict sums, int count) {
    for (int i = 0; i < count; ++i)
        sums[i] += weights[i] * (other[i] - own[i]);
}

/// Denoises some rows of the image, one neighbour of all their pixels after the other.
class Band {
  public:
    Band(const NoisyImage& image, Colours& out, int begin, int end)
        : in_(image),
          out_(out),
          begin_(begin),
          rows_(end - begin),
          width_(image.luminance.size().x),
          patches_(image, begin, end),
          weights_(std::size_t(width_)),
          total_(std::size_t(rows_) * std::size_t(width_)) {}

    void addNeighbour(ivec2 apart) {
        patches_.compare(apart);
        for (int y = 0; y < rows_; ++y) {
            patches_.write(y, weights_.data());
            add(y, apart);
        }
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
    void add(int y, ivec2 apart) {
        const float* weights = weights_.data();
        float* __restrict total = totalRow(y);
        for (int x = 0; x < width_; ++x)
            total[x] += weights[x];
        for (std::size_t c = 0; c < 3; ++c) {
            const Plane& mean = in_.mean[c];
            addDifferences(weights, mean.row(begin_ + y), mean.row(begin_ + y + apart.y) + apart.x,
                           out_[c].row(begin_ + y), width_);
        }
    }

    float* totalRow(int y) { return &total_[std::size_t(y) * std::size_t(width_)]; }

    const NoisyImage& in_;
    Colours& out_;
    int begin_, rows_, width_;
    PatchWeights patches_;
    std::vector<float> weights_;  ///< values of one row
    std::vector<float> total_;
};

}  // namespace

Colours nonLocalMeans(const NoisyImage& image, const std::stop_token& stop) {
    const ivec2 size = image.luminance.size();
    Colours out = coloursOf(size);
    eachBand(size.y, stop, [&](int begin, int end) {
        Band band(image, out, begin, end);
        for (const ivec2 apart : PatchWeights::neighbours()) {
            if (stop.stop_requested())
                break;
            band.addNeighbour(apart);
        }
        band.finish();
    });
    for (Plane& plane : out)
        plane.mirror();
    return out;
}

}  // namespace pdr::denoise
