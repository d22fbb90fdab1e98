#include "render/accuracy/image_change.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/film/display_transform.h"

namespace pdr {
namespace {

constexpr double kSigmas = 1.96;  ///< from the mean to either end of 95 % of a normal distribution
constexpr double kTail = 0.05;    ///< fraction beyond the 95th percentile

/// Mean of one number per pixel, and its uncertainty due to the choice of the pixels.
class PixelMean {
  public:
    void add(double value) {
        ++count_;
        const double off = value - mean_;
        mean_ += off / count_;
        squares_ += off * (value - mean_);
    }
    double value() const { return mean_; }
    double low() const { return mean_ - reach(); }
    double high() const { return mean_ + reach(); }

  private:
    double reach() const { return count_ > 1 ? kSigmas * std::sqrt(squares_ / (count_ * (count_ - 1))) : 0; }

    double count_ = 0, mean_ = 0, squares_ = 0;
};

double signOf(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Statistics of the differences d of all pixels, as seen through noise.
struct Sums {
    PixelMean magnitude;  ///< mean |difference| seen; noise makes it larger than mean |d|
    PixelMean agreement;  ///< component of one half in the direction of the other; noise makes it less than mean |d|
    PixelMean product;    ///< product of both halves; its mean is that of d^2, whatever the noise
    PixelMean seen, squares;

    void add(const HalfDifferences& pixel) {
        double sums[5] = {};
        for (int c = 0; c < 3; ++c) {
            const double even = double(pixel.even[c]), odd = double(pixel.odd[c]), both = (even + odd) / 2;
            sums[0] += std::fabs(both);
            sums[1] += (signOf(even) * odd + signOf(odd) * even) / 2;
            sums[2] += even * odd;
            sums[3] += both;
            sums[4] += both * both;
        }
        PixelMean* const means[5] = {&magnitude, &agreement, &product, &seen, &squares};
        for (int i = 0; i < 5; ++i)
            means[i]->add(sums[i] / 3);
    }
};

/// Returns the value that the fraction `part` of the values exceeds.
double exceededBy(std::vector<double>& values, double part) {
    const auto at =
        values.begin() + std::ptrdiff_t(std::clamp((1 - part) * double(values.size()), 0.0, double(values.size() - 1)));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Returns the value that more than kTail of the differences exceed for certain. Of what one half shows in the
/// direction of the other, the number that points back is subtracted from the number that points forward.
double surelyExceeded(std::vector<double>& agreeing, double pixels) {
    std::ranges::sort(agreeing, std::greater(), [](double x) { return std::fabs(x); });
    const double all = double(agreeing.size());
    double on = 0, back = 0;
    for (const double x : agreeing) {
        (x > 0 ? on : back) += 1 / all;
        if (on - back - kSigmas * std::sqrt((on + back) / pixels) >= kTail)
            return std::fabs(x);
    }
    return 0;
}

/// Returns the 95th percentile of the differences, one number per channel [levels].
Foretold ninetyFifthOf(std::span<const HalfDifferences> pixels, const Sums& sums, double shrink) {
    std::vector<double> seen, told, agreeing;
    for (const HalfDifferences& pixel : pixels)
        for (int c = 0; c < 3; ++c) {
            const double even = double(pixel.even[c]), odd = double(pixel.odd[c]), both = (even + odd) / 2;
            seen.push_back(std::fabs(both));
            told.push_back(std::fabs(std::lerp(sums.seen.value(), both, shrink)));
            agreeing.push_back(signOf(even) * odd);
            agreeing.push_back(signOf(odd) * even);
        }
    const double count = double(pixels.size()), chance = kSigmas * std::sqrt(kTail * (1 - kTail) / count);
    const double largest = std::sqrt(std::max(sums.product.high(), 0.0) / kTail);  // Chebyshev's inequality
    const double high = std::min(exceededBy(seen, std::max(kTail - chance, 0.0)), largest);
    const double value = std::min(exceededBy(told, kTail), high);
    const double low = std::min(2 * value - high, surelyExceeded(agreeing, count));
    return {value, std::clamp(low, 0.0, value), high};
}

/// Returns the slope of the chord of `curve`, a table's function, between `a` and `b`.
template <class Curve>
float chord(const Curve& curve, float a, float b) {
    constexpr float kShortest = 0.02f;  // least length relative to a + b, because the curve is a table
    const float middle = (a + b) / 2, half = glm::max(glm::abs(a - b), kShortest * (a + b)) / 2;
    return half > 0 ? (curve(middle + half) - curve(middle - half)) / (2 * half) : 0;
}

/// How the levels of a pixel differ between two images, as a linear function of how their radiances differ: the halves
/// of the samples are then weighted without bias. A level depends on its own channel and on the largest one.
struct Chords {
    vec3 own{0.0f};        ///< levels per unit of the exposure of the own channel
    vec3 largest{0.0f};    ///< ... of the largest
    int from = 0, to = 0;  ///< the largest channels of both images
};

int largestOf(vec3 light) {
    return light.x >= glm::max(light.y, light.z) ? 0 : light.y >= light.z ? 1 : 2;
}

/// Returns the chords between the images `a` and `b` of a pixel, in units of the exposure. keepsHue shows of channel x
/// beside the largest channel p the light s(p) x + w(p), which changes by the mean s times the change of x, and by the
/// chord of s(p) x + w(p) at the mean x times the change of p; nothing is left over.
Chords chordsOf(const DisplayTransform& transform, vec3 a, vec3 b) {
    Chords chords{.from = largestOf(a), .to = largestOf(b)};
    const float p = a[chords.from], q = b[chords.to];
    const auto grey = [&](float light) { return exactLevelOf(transform.greys, light); };
    const auto level = [&](float light) { return exactLevelOfLight(transform.lights, light); };
    const vec2 hueA = hueAt(transform.hues, p), hueB = hueAt(transform.hues, q);
    for (int c = 0; c < 3; ++c) {
        if (transform.curve == ToneCurve::perChannel || (a[c] == p && b[c] == q)) {
            chords.own[c] = chord(grey, a[c], b[c]);
            continue;
        }
        const auto shown = [&](float largest) {
            const vec2 hue = hueAt(transform.hues, largest);
            return hue.x * (a[c] + b[c]) / 2 + hue.y;
        };
        const float slope = chord(level, hueA.x * a[c] + hueA.y, hueB.x * b[c] + hueB.y);
        chords.own[c] = slope * (hueA.x + hueB.x) / 2;
        chords.largest[c] = slope * chord(shown, p, q);
    }
    return chords;
}

bool shows(const PixelEstimate& pixel) {
    return pixel.tissue || pixel.mean != dvec3(0);
}

}  // namespace

ImageChange changeOf(std::span<const HalfDifferences> pixels) {
    if (pixels.empty())
        return {};
    Sums sums;
    for (const HalfDifferences& pixel : pixels)
        sums.add(pixel);
    const double mean = sums.seen.value(), seenVariance = sums.squares.value() - mean * mean;
    const double variance = sums.product.value() - mean * mean;  // of d
    const double shrink = seenVariance > 0 ? std::sqrt(std::clamp(variance / seenVariance, 0.0, 1.0)) : 0;
    PixelMean told;
    for (const HalfDifferences& pixel : pixels)
        for (int c = 0; c < 3; ++c)
            told.add(std::fabs(std::lerp(mean, double(pixel.even[c] + pixel.odd[c]) / 2, shrink)));
    const double low = std::max(sums.agreement.low(), 0.0);
    const double high = std::max(std::min(sums.magnitude.high(), std::sqrt(std::max(sums.product.high(), 0.0))), low);
    return {{std::clamp(told.value(), low, high), low, high}, ninetyFifthOf(pixels, sums, shrink)};
}

ImageChange imageChange(const Film& with, const Film& without, const Display& display) {
    const DisplayTransform transform = displayTransform(display);
    std::vector<HalfDifferences> pixels;
    for (int y = 0; y < with.size().y; ++y)
        for (int x = 0; x < with.size().x; ++x) {
            const PixelEstimate a = with.pixel(x, y), b = without.pixel(x, y);
            if (!shows(a) && !shows(b))
                continue;
            HalfDifferences& pixel = pixels.emplace_back();
            const double unit = 1 / double(display.exposure);
            const Chords chords = chordsOf(transform, vec3(a.mean * unit), vec3(b.mean * unit));
            const auto levels = [&](dvec3 with, dvec3 without) {
                return chords.own * vec3((with - without) * unit) +
                       chords.largest * float((with[chords.from] - without[chords.to]) * unit);
            };
            pixel.even = levels(a.halves.even, b.halves.even);
            pixel.odd = levels(a.halves.odd, b.halves.odd);
        }
    return changeOf(pixels);
}

}  // namespace pdr
