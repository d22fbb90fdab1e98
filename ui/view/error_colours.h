#pragma once
/// The colours of the error map, from dark violet (accurate) to bright yellow (noisy). In OKLab (Ottosson 2020)
/// lightness, hue and the distance between neighbouring colours change evenly along the scale, so that equal
/// differences in error look equal, also to viewers who see few hues or none.

#include <QColor>
#include <QList>

#include "render/film/error/level_error_map.h"

namespace pdr::ui {

/// Returns the colour of a pixel whose error is within `levels` display levels, >= 0. Infinite: error not known.
QColor errorColour(double levels);

/// Returns the colour of each of the 256 bins of a LevelErrorMap, as the colour table of an indexed image. The bin
/// without tissue is transparent.
QList<QRgb> errorColours();

}  // namespace pdr::ui
