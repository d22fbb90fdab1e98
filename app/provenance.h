#pragma once
/// How a picture came about, from what is known of it.

#include <string>

#include "render/device/schedule.h"
#include "render/film/image_file.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// What makes a picture one to compare with, and not this program's own: "Exposure Render's schedule K1, blurred".
/// Empty: it is its own.
std::string comparisonText(const Schedule& schedule, Estimator estimator);

/// `seconds`: spent on rendering it.
Provenance provenanceOf(const Scene& scene, const FilmStatus& status, double seconds, const Schedule& schedule = {});

}  // namespace pdr::app
