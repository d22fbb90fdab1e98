#pragma once
/// How far a smoothed picture is from the truth, lost detail included, and without knowing the truth: each half of the
/// samples is smoothed alone and judged by the other half as it is, which is right in the mean and has not been seen.
/// After the cross-validation of Rousselle, Knaus & Zwicker 2012. What is judged is the mean of both smoothed halves;
/// all samples smoothed at once, which is what is shown (smoothRadiance), are as good or a little better.

#include <optional>

#include "render/denoise/lost_lines.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/noisy_film.h"

namespace pdr {

/// Of the tissue in a region, or of all its pixels where there is none.
struct SmoothedError {
    double relative = 0;        ///< root mean square error of the luminance over its mean
    double relativeAtMost = 0;  ///< to 95 %
    double levels = 0;          ///< twice the root mean square error of the worst channel [display levels of 255]
    double levelsAtMost = 0;    ///< to 95 %
    /// What no error tells, since it fills so few pixels: of nine lines in ten of this contrast, 2 x 60 pixels large,
    /// the picture keeps 60 %; of fainter ones less. May be above 1.
    double hiddenContrast = 0;
};

/// Samples per pixel below which nothing is said: 2 of each half.
inline constexpr std::uint64_t kSamplesToJudge = 4;

class SmoothingJudgement {
  public:
    /// Takes as long as smoothing the picture twice. Nothing: fewer than kSamplesToJudge samples, or a stop request.
    static std::optional<SmoothingJudgement> of(const Film& film, const std::stop_token& stop = {});

    /// Of a region of the film, which is clipped to it, on a display of that exposure. Nothing where it has tissue in
    /// less than 16 tiles of 16 x 16 pixels, while the picture rests on few bright samples, or while no light
    /// has been seen that may come: too little is known.
    std::optional<SmoothedError> over(const Tile& region, double exposure) const;
    std::optional<SmoothedError> overAll(double exposure) const { return over(area_, exposure); }
    /// Where the denoised image is still rough on a display of that exposure: of each pixel of tissue twice the root
    /// mean square of the errors in 21 x 21 pixels around it, at least an eighth of `stated`, which one square tells
    /// nothing of.
    LevelErrorMap errorMap(double exposure, double stated) const;
    /// That are known to be missing, though the stated error does not tell; see denoise/lost_lines.h.
    const std::vector<denoise::LostLine>& lostLines() const { return lostLines_; }

  private:
    /// Of a pixel, in units of unit_. Squared errors are right in the mean alone: they may be below 0.
    struct Evidence {
        vec3 smooth{0.0f};
        vec3 squaredErrors{0.0f};
        float luminance = 0, squaredError = 0;
        float variance = 0;  ///< of the luminance of all samples, smooth
        float noise = 0;     ///< as raw as it is
        bool rare = false;   ///< less than two bright samples could make the pixel
        bool tissue = false;
        bool unlit = false;
    };
    struct Sums;

    SmoothingJudgement(const Film& film, const NoisyFilm& noisy, const denoise::Colours& even,
                       const denoise::Colours& odd, const std::stop_token& stop);
    Sums sumsIn(const Tile& tile, float exposure, float error) const;
    Sums sumsOver(const Tile& region, float exposure, float error) const;

    Tile area_;
    double unit_;
    double samples_;  ///< that every pixel has
    double sigmas_;   ///< of the sums over tiles, for 95 %
    std::vector<Evidence> evidence_;
    bool tissue_ = false;  ///< there is some: only that counts
    std::vector<denoise::LostLine> lostLines_;
};

/// Whether the smoothed picture is known to be better than the raw one.
inline bool smoothingPays(const SmoothedError& smoothed, const FilmStatus& raw) {
    return smoothed.relativeAtMost < raw.relativeError;
}

}  // namespace pdr
