#pragma once
/// How good the picture is by now, in one line of words.

#include <QString>

#include "render/film/film.h"

namespace pdr::ui {

/// "error 1.8 %, 256 samples, 31 iterations/s, 1 % in about 19 s"; "paused" stands in front when the rendering holds.
/// Nothing without samples.
QString statusText(const FilmStatus& status, double iterationsPerSecond, bool paused);

}  // namespace pdr::ui
