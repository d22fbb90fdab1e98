#pragma once
/// How a film and its denoised image have improved, and when the shown one will reach which quality.

#include "render/accuracy/forecast.h"
#include "render/film/error/shown_status.h"

namespace pdr {

class ShownHistory {
  public:
    void clear() { *this = {}; }
    /// Forgets the errors, as for another display.
    void forgetErrors();
    /// Adds what was known, after `seconds` of rendering, of the film and of the image that was shown. A denoised image
    /// is judged only now and then: the same error again is the same judgement and adds nothing.
    void add(double seconds, const FilmStatus& film, const ShownStatus& shown);

    /// Returns ErrorHistory::points() of the image in `of`.
    std::vector<ErrorPoint> points(ErrorOf of) const;
    /// Returns ErrorHistory::steps() of the image in `of`. A denoised image gives way to the film when that is better,
    /// so steps to come are reached by the sooner of both.
    std::vector<QualityStep> steps(ErrorOf of) const;

  private:
    ErrorHistory film_, denoised_;
    double judged_ = 0;  ///< error of the denoised image that was added last [levels]; 0: none
};

}  // namespace pdr
