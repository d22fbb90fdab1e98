#pragma once
/// The quality of an image in one word: what it is good for at its current error.

#include "render/film/film_status.h"

namespace pdr {

/// Quality by the levels within which 95 % of the tissue lies.
enum class Quality {
    estimating,   ///< not known, or not known yet
    rough,        ///< beyond 16 levels, or based on few bright samples, so that the stated error may be too small
    orientation,  ///< within 16 levels: shows where things are
    planning,     ///< within 8 levels: shows what they look like
    reference     ///< within 1 level: further improvement is not visible
};

inline constexpr double kOrientationLevels = 16, kPlanningLevels = 8;

Quality qualityOf(const FilmStatus& status);

}  // namespace pdr
