#pragma once
/// What the command line says about a picture's error.

#include <string>

#include "render/film/film_status.h"

namespace pdr::app {

/// For a line that changes: "95 % of the tissue within +-9 of 255 grey levels, error 12 %"; "error not known yet".
std::string errorText(const FilmStatus& status);
/// For the end: a whole sentence.
std::string errorSentence(const FilmStatus& status);

}  // namespace pdr::app
