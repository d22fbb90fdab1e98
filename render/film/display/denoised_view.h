#pragma once
/// The denoised image of the current film: its error, and whether to show it. Where the raw film is known to be as
/// good, the raw film is shown, so that the view becomes the film by itself.

#include "render/film/display.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr {

class DenoisedView {
  public:
    /// Forgets the judgement, for another film.
    void clear() { *this = {}; }
    /// Returns whether to judge a film whose currently sampled part has so many samples per pixel: true once there are
    /// `growth` times as many as at the last judgement, or fewer than then, since that is another part. False below
    /// kSamplesToJudge.
    bool isDue(std::uint64_t samples, double growth = 2) const {
        const double judged = double(judgedSamples_);
        return samples >= kSamplesToJudge && (double(samples) >= growth * judged || samples < judgedSamples_);
    }
    /// Returns whether the last judgement was made at another number of samples, and there are enough to judge.
    bool isStale(std::uint64_t samples) const { return samples >= kSamplesToJudge && samples != judgedSamples_; }
    /// Returns the samples per pixel that the film had at the last judgement; 0: none yet.
    std::uint64_t judgedSamples() const { return judgedSamples_; }
    /// Judges the image that `smoother` makes of `film`; `samples`: as passed to isDue(). Changes nothing after a stop
    /// request.
    void judge(const Film& film, std::uint64_t samples, const std::stop_token& stop,
               const HalfSmoother& smoother = denoisedHalves);

    /// Returns `wanted`, without denoising where the raw film is better.
    Display better(Display wanted) const;
    /// Returns the error of the denoised image at the last judgement, on a display of that tone; later images are
    /// better. Nothing if it is not known.
    std::optional<DenoisedError> error(const Tone& tone);
    /// Returns the error of the denoised image over a part of it, as error() does for the whole.
    std::optional<DenoisedError> errorOver(const Tile& part, const Tone& tone) const;
    /// Returns the error map of the denoised image; nothing where error() is not known.
    std::optional<LevelErrorMap> errorMap(const Tone& tone);
    /// Returns the lines that the denoised image lacked at the last judgement; some of them may have come back since.
    std::vector<denoise::LostLine> lostLines() const;
    /// Returns the memory that the judgement holds.
    std::size_t bytes() const { return judgement_ ? judgement_->bytes() : 0; }

  private:
    std::optional<SmoothingJudgement> judgement_;
    std::uint64_t judgedSamples_ = 0;
    bool pays_ = true;
    std::optional<DenoisedError> error_;  ///< error on a display of tone_
    std::optional<Tone> tone_;            ///< tone of error_; none: not yet computed
};

}  // namespace pdr
