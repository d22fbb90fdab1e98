#pragma once
/// What is known of a picture's bias from its scene and its film.

#include <string>

#include "render/accuracy/bias.h"

namespace pdr {

struct FilmStatus;
struct Scene;

/// All but what was measured and how it is shown. `device`: its name, "cpu".
BiasFacts biasFacts(const Scene& scene, const FilmStatus& status, const std::string& device);

}  // namespace pdr
