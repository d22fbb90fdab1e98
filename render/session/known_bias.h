#pragma once
/// What is known of an image's bias from its scene and its film.

#include <string>

#include "render/accuracy/bias.h"

namespace pdr {

struct FilmStatus;
struct Scene;

/// Returns all facts except what was measured and how the image is shown. `device`: its name, "cpu".
BiasFacts biasFacts(const Scene& scene, const FilmStatus& status, const std::string& device);

}  // namespace pdr
