#pragma once
/// What a picture is good for by now, in one word.

#include "render/film/film_status.h"

namespace pdr {

/// By the levels within which 95 % of the tissue lies.
enum class Quality {
    estimating,   ///< not known, or not known yet
    rough,        ///< beyond 16 levels, or resting on few bright samples, which may say too little
    orientation,  ///< within 16: where things are
    planning,     ///< within 8: what they look like
    reference     ///< within 1: more would not be seen
};

inline constexpr double kOrientationLevels = 16, kPlanningLevels = 8;

Quality qualityOf(const FilmStatus& status);

}  // namespace pdr
