#include "render/denoise/regression.h"

#include <algorithm>
#include <cmath>

namespace pdr::denoise {
namespace {

constexpr int kFeatures = Features::kCount;
/// Spread of a feature that is too little to tell anything from: it is added to the variances (ridge regression).
constexpr float kRidge = 0.02f;
constexpr float kFarApart = 30;  ///< depths that differ by as many widths of a pixel differ by 1
constexpr int kRows = 8;         ///< rows whose weights stay in a core's cache
constexpr int kTogether = 16;    ///< pixels that are fitted together
/// Light below which all is dark, and above which nothing is told apart.
constexpr float kLeastLight = 1e-30f, kBrightest = 1e15f;
constexpr int kPairs = kFeatures * (kFeatures + 1) / 2;

using Lanes = std::array<float, kTogether>;

/// Calls work(lane) for all lanes; the compiler makes vectors of them.
template <class Work>
void eachLane(const Work& work) {
    for (std::size_t lane = 0; lane < kTogether; ++lane)
        work(lane);
}

constexpr std::size_t pairOf(std::size_t i, std::size_t j) {
    return i * (i + 1) / 2 + j;
}

/// Sums over the neighbours of some pixels beside each other, of weights times differences from the pixel.
struct Sums {
    Lanes weight{};
    std::array<Lanes, kFeatures> feature{};
    std::array<Lanes, kPairs> pair{};  ///< products of two features, at pairOf(i, j), j <= i
    std::array<Lanes, 3> colour{};
    std::array<std::array<Lanes, 3>, kFeatures> both{};  ///< products of a feature and a colour

    void add(const float* weights, const std::array<Lanes, kFeatures>& features, const std::array<Lanes, 3>& colours) {
        eachLane([&](std::size_t l) { weight[l] += weights[l]; });
        for (std::size_t c = 0; c < 3; ++c)
            eachLane([&](std::size_t l) { colour[c][l] += weights[l] * colours[c][l]; });
        for (std::size_t i = 0; i < kFeatures; ++i) {
            Lanes weighted;
            eachLane([&](std::size_t l) { weighted[l] = weights[l] * features[i][l]; });
            eachLane([&](std::size_t l) { feature[i][l] += weighted[l]; });
            for (std::size_t j = 0; j <= i; ++j)
                eachLane([&](std::size_t l) { pair[pairOf(i, j)][l] += weighted[l] * features[j][l]; });
            for (std::size_t c = 0; c < 3; ++c)
                eachLane([&](std::size_t l) { both[i][c][l] += weighted[l] * colours[c][l]; });
        }
    }

    /// Makes means of the sums, and of the products covariances, those of features with the ridge.
    void centre() {
        eachLane([&](std::size_t l) { weight[l] = 1 / weight[l]; });
        for (std::size_t c = 0; c < 3; ++c)
            eachLane([&](std::size_t l) { colour[c][l] *= weight[l]; });
        for (std::size_t i = 0; i < kFeatures; ++i) {
            eachLane([&](std::size_t l) { feature[i][l] *= weight[l]; });
            for (std::size_t j = 0; j <= i; ++j)
                eachLane([&](std::size_t l) {
                    float& product = pair[pairOf(i, j)][l];
                    product = product * weight[l] - feature[i][l] * feature[j][l];
                });
            eachLane([&](std::size_t l) { pair[pairOf(i, i)][l] += kRidge; });
            for (std::size_t c = 0; c < 3; ++c)
                eachLane(
                    [&](std::size_t l) { both[i][c][l] = both[i][c][l] * weight[l] - feature[i][l] * colour[c][l]; });
        }
    }

    /// Solves the normal equations in place, by L D L^T: `both` becomes the slopes of the colours over the features.
    void solve() {
        for (std::size_t j = 0; j < kFeatures; ++j) {
            Lanes& pivot = pair[pairOf(j, j)];
            for (std::size_t i = j + 1; i < kFeatures; ++i) {
                Lanes& below = pair[pairOf(i, j)];
                Lanes factor;
                eachLane([&](std::size_t l) { factor[l] = below[l] / pivot[l]; });
                for (std::size_t k = j + 1; k <= i; ++k)
                    eachLane([&](std::size_t l) { pair[pairOf(i, k)][l] -= factor[l] * pair[pairOf(k, j)][l]; });
                // Rounding alone brings a pivot below the ridge
                eachLane([&](std::size_t l) { pair[pairOf(i, i)][l] = std::max(pair[pairOf(i, i)][l], kRidge); });
                for (std::size_t c = 0; c < 3; ++c)
                    eachLane([&](std::size_t l) { both[i][c][l] -= factor[l] * both[j][c][l]; });
            }
        }
        for (std::size_t j = kFeatures; j-- > 0;)
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t i = j + 1; i < kFeatures; ++i)
                    eachLane([&](std::size_t l) { both[j][c][l] -= pair[pairOf(i, j)][l] * both[i][c][l]; });
                eachLane([&](std::size_t l) { both[j][c][l] /= pair[pairOf(j, j)][l]; });
            }
    }
};

/// Fits some rows of the image.
class Rows {
  public:
    Rows(const NoisyImage& image, const Features& features, Colours& out, int begin, int end)
        : in_(image),
          features_(features),
          out_(out),
          begin_(begin),
          rows_(end - begin),
          width_(image.luminance.size().x),
          padded_((width_ + kTogether - 1) / kTogether * kTogether),
          weights_(PatchWeights::neighbours().size() * std::size_t(rows_) * std::size_t(padded_)) {}

    void weigh(const std::stop_token& stop) {
        PatchWeights patches(in_, begin_, begin_ + rows_);
        for (std::size_t i = 0; i < PatchWeights::neighbours().size() && !stop.stop_requested(); ++i) {
            patches.compare(PatchWeights::neighbours()[i]);
            for (int y = 0; y < rows_; ++y)
                patches.write(y, weightsOf(i, y));
        }
    }

    void fit() {
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < width_; x += kTogether)
                fit(std::max(std::min(x, width_ - kTogether), 0), y);
    }

  private:
    float* weightsOf(std::size_t neighbour, int y) {
        return &weights_[(neighbour * std::size_t(rows_) + std::size_t(y)) * std::size_t(padded_)];
    }

    /// Fits kTogether pixels from (x, y) on; those beyond the image are not kept.
    void fit(int x, int y) {
        Sums sums;
        for (std::size_t i = 0; i < PatchWeights::neighbours().size(); ++i)
            add(sums, weightsOf(i, y) + x, {x, begin_ + y}, PatchWeights::neighbours()[i]);
        sums.centre();
        sums.solve();
        // Where the pixel is, all differences from it are 0
        for (std::size_t c = 0; c < 3; ++c) {
            Lanes change = sums.colour[c];
            for (std::size_t i = 0; i < kFeatures; ++i)
                eachLane([&](std::size_t l) { change[l] -= sums.both[i][c][l] * sums.feature[i][l]; });
            const float* own = in_.mean[c].row(begin_ + y) + x;
            float* to = out_[c].row(begin_ + y) + x;
            for (std::size_t l = 0; l < std::size_t(std::min(kTogether, width_ - x)); ++l)
                to[l] = own[l] + change[l];
        }
    }

    void add(Sums& sums, const float* weights, ivec2 at, ivec2 apart) const {
        const auto differences = [&](const Plane& plane) {
            const float *own = plane.row(at.y) + at.x, *other = plane.row(at.y + apart.y) + at.x + apart.x;
            Lanes lanes;
            eachLane([&](std::size_t l) { lanes[l] = other[l] - own[l]; });
            return lanes;
        };
        std::array<Lanes, kFeatures> features;
        for (int i = 0; i < kFeatures; ++i)
            features[std::size_t(i)] = differences(features_[i]);
        sums.add(weights, features, {differences(in_.mean[0]), differences(in_.mean[1]), differences(in_.mean[2])});
    }

    const NoisyImage& in_;
    const Features& features_;
    Colours& out_;
    int begin_, rows_, width_, padded_;
    std::vector<float> weights_;  ///< weights of all neighbours, row by row
};

}  // namespace

Features::Features(const Guides& guides) {
    const auto times = [](float a, float b) { return a * b; };
    // Returns the mean over both guides of a plane made of each
    const auto averaged = [&](const auto& planeOf) {
        return combined([](float a, float b) { return 0.5f * (a + b); }, planeOf(*guides[0]), planeOf(*guides[1]));
    };
    const Plane opacity = averaged([](const Guide& guide) -> const Plane& { return guide.opacity; });
    // Brightness: half of the tissue's mean is as far from 0 as infinity is from it
    const auto light = [](float value) { return value > 0 ? std::min(value, kBrightest) : 0.0f; };
    const Plane bright = averaged([&](const Guide& guide) { return combined(light, luminance(guide.radiance)); });
    const double shown = meanOf(opacity), mean = shown > 0 ? meanOf(bright) / shown : 0;
    const auto usual = float(std::clamp(mean, double(kLeastLight), double(kBrightest)));
    planes_[0] = combined([usual](float value) { return 2 * value / (value + usual); }, bright);
    for (std::size_t c = 0; c < 3; ++c)
        planes_[1 + c] = averaged([&](const Guide& guide) -> const Plane& { return guide.normal[c]; });
    // Depth: what is empty lies at the mean
    const Plane weighted = averaged([&](const Guide& guide) { return combined(times, guide.depth, guide.opacity); });
    const auto middle = float(shown > 0 ? meanOf(weighted) / shown : 0);
    planes_[4] = combined([middle](float sum, float part) { return part > 0 ? (sum / part - middle) / kFarApart : 0; },
                          weighted, opacity);
    planes_[5] = opacity;
}

Colours regressed(const NoisyImage& image, const Features& features, const std::stop_token& stop) {
    const ivec2 size = image.luminance.size();
    Colours out = coloursOf(size);
    eachBand(size.y, stop, [&](int begin, int end) {
        for (int y = begin; y < end && !stop.stop_requested(); y += kRows) {
            Rows rows(image, features, out, y, std::min(y + kRows, end));
            rows.weigh(stop);
            rows.fit();
        }
    });
    for (Plane& plane : out)
        plane.mirror();
    return out;
}

}  // namespace pdr::denoise
