#pragma once
/// The colours of the error map: dark violet is fine, bright yellow is rough. In OKLab (Ottosson 2020) lightness, hue
/// and the distance between neighbours are even along the scale, so that what looks twice as far apart is, also to
/// those who see few hues or none.

#include <QColor>
#include <QList>

#include "render/film/error/level_error_map.h"

namespace pdr::ui {

/// Of a pixel that is within so many levels, >= 0; infinite: not known.
QColor errorColour(double levels);

/// Of each bin of a LevelErrorMap, as an image of indices wants them; no tissue: nothing is painted.
QList<QRgb> errorColours();

}  // namespace pdr::ui
