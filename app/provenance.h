#pragma once
/// How a picture came about, from what is known of it.

#include "render/film/image_file.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// `seconds`: spent on rendering it.
Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds);

}  // namespace pdr::app
