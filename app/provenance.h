#pragma once
/// How a picture came about, from what is known of it.

#include <string>

#include "render/film/image_file.h"
#include "render/scene/schedule.h"

namespace pdr {
struct Scene;
}

namespace pdr::app {

/// A schedule that is for comparison: "Exposure Render's K1, blurred". Empty: ours.
std::string scheduleText(const Schedule& schedule);

/// `seconds`: spent on rendering it.
Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds);

}  // namespace pdr::app
