#pragma once
/// What is known of an image's bias from its scene and its film.

#include <string>

#include "render/accuracy/bias.h"

namespace pdr {

struct FilmStatus;
struct Scene;

/// Returns whether the texture units of a device read the volume: its samples then differ from those of the CPU.
/// `device`: its name, "cpu".
bool texturesFilter(const Scene& scene, const std::string& device);

/// Returns all facts except what was measured and how the image is shown. `device`: as above.
BiasFacts biasFacts(const Scene& scene, const FilmStatus& status, const std::string& device);

}  // namespace pdr
