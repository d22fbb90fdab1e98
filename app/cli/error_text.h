#pragma once
/// Texts of the command line about the error of an image.

#include <string>

#include "render/film/film_status.h"

namespace pdr::app {

/// Returns a short text for the progress line: "95 % of the tissue within +-9 of 255 grey levels, error 12 %"; "error
/// not known yet".
std::string errorText(const FilmStatus& status);
/// Returns a complete sentence for the final report.
std::string errorSentence(const FilmStatus& status);

}  // namespace pdr::app
