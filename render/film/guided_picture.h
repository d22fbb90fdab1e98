#pragma once
/// What a screen shows of a coarse film while the hand moves: the film's light on a guide that is finer than it.

#include "render/denoise/guided.h"
#include "render/film/tone_map.h"

namespace pdr {

/// As large as the guide, which is of the film's own scene; `smoothed`. The same bits for any number of threads.
Picture guidedPicture(const Film& film, const denoise::Guide& guide, const Display& display);

}  // namespace pdr
