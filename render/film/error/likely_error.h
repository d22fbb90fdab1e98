#pragma once
/// Likely errors of single pixels: standard errors of which 1.96 to either side hold the truth in 94 to 97 % of the
/// tissue (tools/measure/stated_coverage), where localErrors() is a bound. Low-discrepancy points are 1.2 to 30 times
/// better than the independent samples that a bound presumes; only the halves of the samples show how much.

#include "render/denoise/plane.h"
#include "render/film/film.h"

namespace pdr {

/// Returns the likely standard errors of the means of the pixels in `part` of the film, at least one, a plane for each
/// channel: localErrors() scaled by the ratio of the real noise in 13 x 13 pixels around, estimated from the draws of
/// their errors (errorDrawOf()), to the presumed noise. Never more than localErrors(); infinite and 0 where those are.
denoise::Colours likelyErrors(const Film& film, const Tile& part);

/// Errors of pixels as a map of levels needs them.
struct LikelyErrors {
    denoise::Colours errors;  ///< likelyErrors()
    /// Correlation of the errors of two channels, in [0, 1], one for all pairs: 1 where they are brighter and darker
    /// together, as under white light; estimated from the draws in 13 x 13 pixels.
    denoise::Plane correlation;
};
LikelyErrors likelyErrorsAndCorrelation(const Film& film, const Tile& part);

}  // namespace pdr
