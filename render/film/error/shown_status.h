#pragma once
/// The status of the image on the screen: the film as it is, or the film denoised, which has an error of its own.

#include <optional>

#include "render/film/error/smoothing_judgement.h"
#include "render/film/film_status.h"

namespace pdr {

/// The image that an error refers to.
enum class ErrorOf {
    film,            ///< the film, which is shown without denoising
    denoised,        ///< the denoised image, which is shown
    beforeDenoising  ///< the film, though it is shown denoised: the error of the denoised image is not known
};

struct ShownStatus {
    FilmStatus status;  ///< status of the film; displayError and its spread are those of the image in `of`
    ErrorOf of = ErrorOf::film;
};

/// Returns the status of the image shown of a film. `error`: of the denoised image, on the display of `film`; used
/// where `denoised` is shown. The displayError is then levelsAtMost, the bound that holds to 95 %.
ShownStatus shownStatus(const FilmStatus& film, bool denoised, const std::optional<DenoisedError>& error);

}  // namespace pdr
