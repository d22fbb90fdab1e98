#pragma once
/// The quality of the current film's images: their errors over time, and when these are determined anew.
///   coarse film     is soon replaced by a finer one; nothing is stated about its images but their samples
///   samples         those of each pixel of the part of the image that is being sampled, if nothing else is said
///   seconds ahead   time already spent on samples that a part of the image has and the rest is still to get

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/accuracy/shown_history.h"
#include "render/film/display/denoised_view.h"
#include "render/film/error/error_map_view.h"
#include "render/session/region.h"
#include "render/session/session.h"
#include "render/session/stop_request.h"

namespace pdr {

class Accumulator;

class QualityTracker {
  public:
    explicit QualityTracker(SessionClock clock) : clock_(std::move(clock)) {}

    /// Forgets the errors of the film's images, because it lost samples or its device. Its time and the region stay.
    void clear();
    /// Starts with an empty film. The region stays.
    void startOver(bool isCoarse);

    /// Returns the time spent on the film, without the current frame [s].
    double seconds() const { return seconds_; }
    /// Adds time that the film's samples or images took.
    void addSeconds(double seconds) { seconds_ += seconds; }

    /// What is known of the denoised image. A snapshot may judge it, too.
    DenoisedView& denoised() { return denoised_; }
    const DenoisedView& denoised() const { return denoised_; }
    /// Returns whether the denoised image is to be judged: now and then while rendering continues (`renders`), and
    /// when it stops.
    bool isJudgementDue(std::uint64_t samples, bool renders) const;
    /// Judges the denoised image, which `smoother` makes of the film. This takes longer than an image may; a stop
    /// request changes nothing. Errors: the device's.
    Result<void> judge(Accumulator& film, std::uint64_t samples, const std::stop_token& stop,
                       const HalfSmoother& smoother = denoisedHalves);

    /// Returns whether errors are to be counted for a display of that tone when pixels have so many samples on
    /// average. Until then the last counts remain valid.
    bool isSurveyDue(double meanSamples, const Tone& tone) const;
    /// Completes the status of an image with the errors counted last, and records its error unless the film is coarse.
    void record(Image& image, const Tone& tone, double secondsAhead);

    /// Updates the error map of the image shown last, if it is due; a coarse film has none. Changes nothing after a
    /// stop request. Errors: the device's.
    Result<void> mapErrors(Accumulator& film, std::uint64_t samples, const Tone& tone, const std::stop_token& stop);
    void dropErrorMap() { errorMap_.clear(); }

    /// Sets the region; none: no part of the image takes precedence.
    void chooseRegion(const std::optional<Region>& region) { region_.choose(region); }
    const RegionView& region() const { return region_; }
    /// Updates the status of the region, if there is one and it is due. `samples`: those of each of its pixels.
    /// `display`: as requested. Errors: the device's.
    Result<void> lookAtRegion(Accumulator& film, std::uint64_t samples, const Display& display);

    /// Returns the memory that the last judgement holds.
    std::size_t bytes() const { return denoised_.bytes(); }

    /// Returns the progress of the image shown last, of a film that has so many samples in every pixel.
    ImageProgress progress(std::uint64_t samples) const;
    /// Adds to `frame`, which has its image, status, display and stop rule, what is known of its quality.
    void describe(Frame& frame, double secondsAhead);

  private:
    ShownStatus shown(const FilmStatus& film, bool isDenoised, const Tone& tone);
    void completeStatus(Image& image) const;
    std::vector<QualityStep> steps(ErrorOf of, double secondsAhead) const;

    SessionClock clock_;
    bool isCoarse_ = false;  ///< the film is coarse
    double seconds_ = 0;
    std::optional<double> shownError_;  ///< error of the full image shown last [levels]; none if there is none
    ErrorOf shownOf_ = ErrorOf::film;   ///< image that shownError_ describes
    FilmStatus surveyed_;               ///< status of the last image whose errors were counted
    ShownHistory history_;              ///< errors of the full images
    Tone historyTone_{0};               ///< tone at which the errors in history_ were taken
    DenoisedView denoised_;
    double judgeSeconds_ = 0;  ///< duration of the last judgement of denoised_
    double judgedAt_ = 0;      ///< seconds_ at the end of that judgement
    ErrorMapView errorMap_;
    double mapSeconds_ = 0;  ///< part of seconds_ spent on errorMap_
    RegionView region_;
};

}  // namespace pdr
