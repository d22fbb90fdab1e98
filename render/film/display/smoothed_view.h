#pragma once
/// What is known of the smoothed picture of the film in hand, and whether it is the one to show: where the raw one is
/// known to be as good, that is shown, so that the view becomes the film by itself.

#include "render/film/display.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr {

class SmoothedView {
  public:
    /// Another film.
    void clear() { *this = {}; }
    /// Whether a film is to be judged, the part of which that is being sampled has so many samples: when they are
    /// `growth` times as many, and where that is another part.
    bool isDue(std::uint64_t samples, double growth = 2) const {
        const double judged = double(judgedSamples_);
        return samples >= kSamplesToJudge && (double(samples) >= growth * judged || samples < judgedSamples_);
    }
    /// Whether it is judged by other samples than these.
    bool isStale(std::uint64_t samples) const { return samples >= kSamplesToJudge && samples != judgedSamples_; }
    /// Samples that the film had when it was judged last; 0: it was not.
    std::uint64_t judgedSamples() const { return judgedSamples_; }
    /// As isDue() was asked. Nothing changes after a stop request.
    void judge(const Film& film, std::uint64_t samples, const std::stop_token& stop);

    /// `wanted`, raw where that is better.
    Display better(Display wanted) const;
    /// Of the smoothed picture when it was last judged, on a display of that exposure; later ones are better.
    std::optional<SmoothedError> error(double exposure);
    /// Of a part of it alone.
    std::optional<SmoothedError> errorOver(const Tile& part, double exposure) const;
    /// Where it is still rough, as far as error() is known there.
    std::optional<LevelErrorMap> errorMap(double exposure);
    /// Of it, too: some of them may have come back since.
    std::vector<denoise::LostLine> lostLines() const;

  private:
    std::optional<SmoothingJudgement> judgement_;
    std::uint64_t judgedSamples_ = 0;
    bool pays_ = true;
    std::optional<SmoothedError> error_;  ///< with ...
    double exposure_ = 0;                 ///< 0: not yet asked for
};

}  // namespace pdr
