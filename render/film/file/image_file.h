#pragma once
/// Images saved to disk, without a patient's name or origin. A face identifies its owner all the same, so a new file is
/// readable by the user alone (0600), and one that is replaced keeps its mode. The file is written beside its place and
/// renamed: an error leaves the old file as it was, and so does a stop request until then: Error cancelled().

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/film/display.h"
#include "render/film/display/denoised_view.h"
#include "render/film/file/provenance.h"
#include "render/film/film.h"

namespace pdr {

/// Paints annotations over an image of `size` pixels, 4 bytes each, row by row from the top. Empty: paints nothing.
using PaintOver = std::function<void(ivec2 size, std::vector<std::uint8_t>& rgba)>;

/// Writes a tone-mapped 8-bit sRGB PNG with the provenance as text chunks. A denoised image is marked as such there,
/// with its error; where the film itself is better, the film is written instead.
Result<void> writePng(const Film& film, const Display& display, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver = {},
                      const std::stop_token& stop = {});
/// Writes a PNG as above, of a film that `view` has judged already where a denoised image is requested.
Result<void> writePng(const Film& film, const Display& display, DenoisedView& view, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver = {},
                      const std::stop_token& stop = {});

/// An image read from a file: linear radiance, row by row from the top.
struct RadianceImage {
    ivec2 size{0};
    std::vector<vec3> pixels;
};

/// Reads the R, G, B (or Y) channels of an OpenEXR file; at most kLongestSide pixels an edge. Errors: no such file, no
/// OpenEXR file, damaged, too large, without these channels; cancelled().
Result<RadianceImage> readExr(const std::filesystem::path& path, const Progress& progress = noProgress);

/// Writes a scene-linear OpenEXR file, float, with the provenance as attributes. Channels: R, G, B; error.R, error.G,
/// error.B, standard errors of the means (likelyErrors()); bound.R, bound.G, bound.B, their bounds (localErrors()).
Result<void> writeExr(const Film& film, const Provenance& provenance, const std::filesystem::path& path,
                      const std::stop_token& stop = {});

}  // namespace pdr
