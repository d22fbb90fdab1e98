#pragma once
/// How a film and its denoised image became better, and when the one that is shown will be how good.

#include "render/accuracy/forecast.h"
#include "render/film/error/shown_status.h"

namespace pdr {

class ShownHistory {
  public:
    void clear() { *this = {}; }
    /// Other errors from now on, as on another display.
    void forgetErrors();
    /// What was known after `seconds` of rendering of the film and of what was shown of it. A denoised image is judged
    /// now and then: the same error again is the same judgement, and says nothing new.
    void add(double seconds, const FilmStatus& film, const ShownStatus& shown);

    /// ErrorHistory::points() of the image in `of`.
    std::vector<ErrorPoint> points(ErrorOf of) const;
    /// ErrorHistory::steps() of that image. A denoised image gives way to the film where that is better: steps to come
    /// are reached by the sooner of both.
    std::vector<QualityStep> steps(ErrorOf of) const;

  private:
    ErrorHistory film_, denoised_;
    double judged_ = 0;  ///< error of the denoised image that was added last [levels]; 0: none
};

}  // namespace pdr
