#pragma once
/// Pictures on disk, without name or origin of a patient; but a face is one's own, so a new file is for its owner alone
/// (0600), and one that is replaced keeps its mode. Written beside and renamed into place: an error leaves the old file
/// as it was, and so does a stop request until then: Error cancelled().

#include <filesystem>
#include <functional>
#include <stop_token>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/film/display.h"
#include "render/film/display/smoothed_view.h"
#include "render/film/file/provenance.h"
#include "render/film/film.h"

namespace pdr {

/// Paints what is to be read in an image over its `size` pixels, 4 bytes each, row by row from the top. Empty: nothing.
using PaintOver = std::function<void(ivec2 size, std::vector<std::uint8_t>& rgba)>;

/// Tone-mapped 8-bit sRGB PNG with the provenance as text chunks. A smoothed one says so there, with its error; where
/// the film itself is better, that is written instead.
Result<void> writePng(const Film& film, const Display& display, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver = {},
                      const std::stop_token& stop = {});
/// The same of a film that `view` has judged already, where a smoothed picture is wanted.
Result<void> writePng(const Film& film, const Display& display, SmoothedView& view, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver = {},
                      const std::stop_token& stop = {});

/// A picture that was read: linear radiance, row by row from the top.
struct RadianceImage {
    ivec2 size{0};
    std::vector<vec3> pixels;
};

/// The R, G, B (or Y) channels of an OpenEXR file; at most kLongestSide pixels an edge. Errors: no such file, no
/// OpenEXR file, damaged, too large, without these channels; cancelled().
Result<RadianceImage> readExr(const std::filesystem::path& path, const Progress& progress = noProgress);

/// Scene-linear OpenEXR, float, with the provenance as attributes: R, G, B; error.R, error.G, error.B, standard errors
/// of the means (likelyErrors()); bound.R, bound.G, bound.B, what they are at most (localErrors()).
Result<void> writeExr(const Film& film, const Provenance& provenance, const std::filesystem::path& path,
                      const std::stop_token& stop = {});

}  // namespace pdr
