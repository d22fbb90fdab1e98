#pragma once
/// Error estimates of single pixels as planes, for filters that read a little beyond the requested pixels.

#include "render/denoise/plane.h"
#include "render/film/film.h"

namespace pdr {

/// Estimates of the pixels in `area` of a film; pixel (0, 0) of the planes is the corner of `area`.
struct ErrorPlanes {
    Tile area;
    denoise::Colours squares;     ///< squares of the standard errors, per channel
    denoise::Plane light;         ///< luminance of the means
    denoise::Plane lightSquares;  ///< squared luminance of the standard errors; infinite below 2 samples
    denoise::Plane drawSquares;   ///< squared luminance of draws of the error
    denoise::Plane tissue;        ///< 1: a sample met tissue
    denoise::Plane jointDraws;    ///< squared sum of the channels' draws, each in units of its standard error
    denoise::Plane ownDraws;      ///< sum of their squares
};

/// Returns the planes of `part`, at least one pixel, and of what lies up to `radius` pixels around it, as far as the
/// film goes.
ErrorPlanes errorPlanesAround(const Film& film, const Tile& part, int radius);

/// Returns the pixels of `part` from `plane`, which covers the pixels in `area`.
denoise::Plane cropped(const denoise::Plane& plane, const Tile& area, const Tile& part);

}  // namespace pdr
