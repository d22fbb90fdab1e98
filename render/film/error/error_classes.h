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
    /// `squaredSum`: estimate of the squared error of the three channels' sum.
    void add(LookBin bin, vec3 squaredErrors, float squaredSum);
    void add(const ErrorSums& other);

  private:
    friend class ErrorClasses;
    struct Bin {
        double pixels = 0;
        dvec3 errors{0.0};
        dvec3 squares{0.0};  ///< sum of the squares of `errors`
        double sums = 0;     ///< squared errors of the channels' sum

        void add(const Bin& other);
        dvec3 variance() const;
        double correlation() const;
    };

    std::array<std::array<Bin, LookBin::kContrast>, LookBin::kBrightness> bins_{};
};

/// The variance of the error of each channel and how the channels go together, constant in classes of bins with about
/// as many pixels each: classes of brightness, and in each of them classes of contrast.
class ErrorClasses {
  public:
    /// Classes at most. Fewer of brightness mix errors of different sizes; with half as many again, or more of
    /// contrast, the statement is the same within 2 %.
    static constexpr int kBrightness = 8, kContrast = 3;

    /// Every variance is 0.
    ErrorClasses() = default;
    explicit ErrorClasses(const ErrorSums& sums);

    vec3 variance(LookBin bin) const { return errors_[bin.brightness][bin.contrast].variance; }
    /// Returns the correlation of two channels' errors, in [0, 1], one for all pairs; see channel_margin.h.
    float correlation(LookBin bin) const { return errors_[bin.brightness][bin.contrast].correlation; }

  private:
    struct ClassError {
        vec3 variance{0.0f};
        float correlation = 1;
    };

    std::array<std::array<ClassError, LookBin::kContrast>, LookBin::kBrightness> errors_{};
};

}  // namespace pdr
