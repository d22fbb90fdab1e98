#pragma once
/// How good the image on the screen is: the film as it is, or the film denoised, which has an error of its own.

#include <optional>

#include "render/film/error/smoothing_judgement.h"
#include "render/film/film_status.h"

namespace pdr {

/// Which image an error speaks of.
enum class ErrorOf {
    film,            ///< the film, which is shown as it is
    denoised,        ///< the denoised image, which is shown
    beforeDenoising  ///< the film, though it is shown denoised: how far the denoised image is off is not known
};

struct ShownStatus {
    FilmStatus status;  ///< the film's; displayError and its spread are those of the image in `of`
    ErrorOf of = ErrorOf::film;
};

/// Status of what is shown of a film. `error`: of the denoised image, on the display of `film`; it counts where
/// `denoised` is shown. Its displayError is the bound that holds to 95 %, levelsAtMost.
ShownStatus shownStatus(const FilmStatus& film, bool denoised, const std::optional<SmoothedError>& error);

}  // namespace pdr
