#pragma once
/// What single pixels know of their error, as planes, whose filters look a little beyond the pixels that are asked for.

#include "render/denoise/plane.h"
#include "render/film/film.h"

namespace pdr {

/// Of the pixels in `area` of a film; (0, 0) of the planes is its corner.
struct ErrorPlanes {
    Tile area;
    denoise::Colours squares;     ///< of the standard errors
    denoise::Plane light;         ///< luminance of the means, ...
    denoise::Plane lightSquares;  ///< ... of the standard errors, squared; infinite below 2 samples
    denoise::Plane drawSquares;   ///< ... and of draws of the error, squared
    denoise::Plane tissue;        ///< 1: a sample met some
};

/// Of `part`, at least one pixel, and what is up to `radius` pixels around it, as far as the film goes.
ErrorPlanes errorPlanesAround(const Film& film, const Tile& part, int radius);

/// What `plane`, of the pixels in `area`, says of those in `part`.
denoise::Plane cropped(const denoise::Plane& plane, const Tile& area, const Tile& part);

}  // namespace pdr
