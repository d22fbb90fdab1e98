#pragma once
/// Estimates the error of a denoised image, lost detail included, without knowing the truth: each half of the samples
/// is denoised alone and compared with the other half as it is, which is unbiased and independent of the first. After
/// the cross-validation of Rousselle, Knaus & Zwicker 2012. The mean of both denoised halves is judged; all samples
/// denoised at once, which is what is shown (smoothRadiance), are as good or a little better.

#include <functional>
#include <memory>
#include <optional>

#include "render/denoise/lost_lines.h"
#include "render/film/error/error_classes.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/noisy_film.h"

namespace pdr {

/// The error of a denoised image over the tissue in a region, or over all its pixels where the film has no tissue.
struct DenoisedError {
    double relative = 0;        ///< root mean square error of the luminance over its mean
    double relativeAtMost = 0;  ///< upper bound of `relative`, to 95 %
    double levels = 0;          ///< error that 95 % of the pixels do not exceed in any channel [display levels of 255]
    double levelsAtMost = 0;    ///< upper bound of `levels`, to 95 %
    /// Contrast of lines that may be lost although no error shows it, since they fill so few pixels: nine in ten
    /// lines of this contrast, 2 x 60 pixels large, keep 60 % of it; fainter ones keep less. May be above 1.
    double hiddenContrast = 0;
};

/// Samples per pixel below which nothing is stated: 2 of each half.
inline constexpr std::uint64_t kSamplesToJudge = 4;

/// Two smooth images in units of NoisyFilm::unit: `even` knows nothing of the samples with odd numbers, `odd` nothing
/// of the others. What else they know is the same for both, and independent of the film.
struct SmoothHalves {
    denoise::Colours even, odd;
};
/// Makes the smooth halves of a film. Worthless after a stop request.
using HalfSmoother = std::function<SmoothHalves(const NoisyFilm&, const std::stop_token&)>;
/// Returns the halves of `noisy`, each denoised alone.
SmoothHalves denoisedHalves(const NoisyFilm& noisy, const std::stop_token& stop);
/// Returns what denoises each half alone, on features that know neither.
HalfSmoother smootherOn(std::shared_ptr<const denoise::Features> features);

class SmoothingJudgement {
  public:
    /// Judges `film`, which takes as long as denoising the image twice. Nothing: fewer than kSamplesToJudge samples, or
    /// a stop request.
    static std::optional<SmoothingJudgement> of(const Film& film, const std::stop_token& stop = {}) {
        return of(film, denoisedHalves, stop);
    }
    /// Judges the image that `smoother` makes of `film`.
    static std::optional<SmoothingJudgement> of(const Film& film, const HalfSmoother& smoother,
                                                const std::stop_token& stop = {});

    /// Returns the error over a region, which is clipped to the film, on a display of that tone. Nothing if too
    /// little is known: where the region has tissue in less than 16 tiles of 16 x 16 pixels, while the image rests on
    /// few bright samples, or while no light has been seen that may come.
    std::optional<DenoisedError> over(const Tile& region, const Tone& tone) const;
    std::optional<DenoisedError> overAll(const Tone& tone) const { return over(area_, tone); }
    /// Returns the error map of the denoised image on a display of that tone: for each pixel of tissue the 95 %
    /// margin of an error as pixels that look alike have over the whole image, times the ratio of both in 21 x 21
    /// pixels around it; at least an eighth of `stated`, since a single square is no evidence of less.
    LevelErrorMap errorMap(const Tone& tone, double stated) const;
    /// Lines that are known to be missing, though the stated error does not show it; see denoise/lost_lines.h.
    const std::vector<denoise::LostLine>& lostLines() const { return lostLines_; }
    /// Returns the memory that it holds.
    std::size_t bytes() const { return evidence_.size() * sizeof(Evidence); }

  private:
    /// Evidence from one pixel, in units of unit_. Squared errors are unbiased, so that single ones may be below 0.
    struct Evidence {
        vec3 smooth{0.0f};
        vec3 squaredErrors{0.0f};
        float squaredSum = 0;  ///< squared error of the channels' sum
        float luminance = 0, squaredError = 0;
        float variance = 0;  ///< variance of the luminance of all samples, averaged over neighbours
        float noise = 0;     ///< squared standard error of the luminance, not averaged
        LookBin look;
        bool rare = false;  ///< less than two bright samples could make the pixel
        bool tissue = false;
        bool unlit = false;
    };
    struct Sums;

    SmoothingJudgement(const Film& film, const NoisyFilm& noisy, const denoise::Colours& even,
                       const denoise::Colours& odd, const std::stop_token& stop);
    Sums sumsIn(const Tile& tile) const;
    Sums sumsOver(const Tile& region) const;
    template <class Work>
    void eachJudged(const Tile& tile, const Work& work) const;
    ErrorClasses errorsOver(const Tile& region) const;

    Tile area_;
    double unit_;
    double samples_;  ///< samples that every pixel has
    double sigmas_;   ///< standard deviations of the sums over tiles, for 95 %
    std::vector<Evidence> evidence_;
    bool tissue_ = false;  ///< the film has tissue: only tissue counts
    std::vector<denoise::LostLine> lostLines_;
};

/// Returns whether the denoised image is known to be better than the raw one.
inline bool smoothingPays(const DenoisedError& denoised, const FilmStatus& raw) {
    return denoised.relativeAtMost < raw.relativeError;
}

}  // namespace pdr
