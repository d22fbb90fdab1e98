#pragma once
/// The squared error of a denoised image's pixels by their brightness and their contrast with their neighbours. A
/// single pixel's squared error is unbiased but little more than noise; means over pixels that look alike are known
/// well. Errors and the slope of the tone curve both go by brightness, so that a mean over bright and dark pixels would
/// exaggerate what errors are in levels; contrast tells edges, which keep their noise, from smooth shade.

#include <array>
#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

/// A bin of pixels that look alike: brightness in doublings of the luminance, two bins each, and contrast in halvings.
struct LookBin {
    static constexpr int kBrightness = 48, kContrast = 16;

    std::uint8_t brightness = 0, contrast = 0;

    /// Returns the bin of a pixel of that luminance, whose mean over the image is about 1, between neighbours of
    /// luminances from `low` to `high`.
    static LookBin of(float luminance, float low, float high);
};

/// Sums of unbiased estimates of squared errors, by bins.
class ErrorSums {
  public:
    void add(LookBin bin, vec3 squaredErrors);
    void add(const ErrorSums& other);

  private:
    friend class ErrorClasses;
    struct Bin {
        double pixels = 0;
        dvec3 errors{0.0};
        dvec3 squares{0.0};  ///< sum of the squares of `errors`

        void add(const Bin& other);
        dvec3 variance() const;
    };

    std::array<std::array<Bin, LookBin::kContrast>, LookBin::kBrightness> bins_{};
};

/// The variance of the error of each channel, constant in classes of bins with about as many pixels each: classes of
/// brightness, and in each of them classes of contrast.
class ErrorClasses {
  public:
    /// Classes at most. Fewer of brightness mix errors of different sizes; with half as many again, or more of
    /// contrast, the statement is the same within 2 %.
    static constexpr int kBrightness = 8, kContrast = 3;

    /// Every variance is 0.
    ErrorClasses() = default;
    explicit ErrorClasses(const ErrorSums& sums);

    vec3 variance(LookBin bin) const { return variances_[bin.brightness][bin.contrast]; }

  private:
    std::array<std::array<vec3, LookBin::kContrast>, LookBin::kBrightness> variances_{};
};

}  // namespace pdr
