#pragma once
/// Pictures on disk, without name or origin of a patient; but a face is one's own, so a new file is for its owner alone
/// (0600), and one that is replaced keeps its mode. Written beside and renamed into place: an error leaves the old file
/// as it was.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

/// How a picture came about: samples, seconds, seed, model, estimator, extinction scale, program version, schedule.
struct Provenance {
    std::uint64_t samplesPerPixel = 0;
    double seconds = 0;
    double relativeError = 0;
    Health health;
    std::uint64_t seed = 0;
    std::string model;
    double extinctionPerMm = 0;
    std::string program;    ///< "PD-Render 0.1.0"
    std::string estimator;  ///< "kroesMarch (biased)"; empty: the unbiased one
    std::string schedule;   ///< "Exposure Render's K1, blurred"; empty: ours
    std::string warnings;   ///< what is known to be off about the scene: "overDense"; empty: nothing
    std::string remarks;    ///< on the import of the voxels, in words: "lossy clipped"; empty: none
};

/// Tone-mapped 8-bit sRGB PNG with the provenance as text chunks. A smoothed one says so there, with its error; where
/// the film itself is better, that is written instead.
Result<void> writePng(const Film& film, const Display& display, const Provenance& provenance,
                      const std::filesystem::path& path);

/// A picture that was read: linear radiance, row by row from the top.
struct RadianceImage {
    ivec2 size{0};
    std::vector<vec3> pixels;
};

/// The R, G, B (or Y) channels of an OpenEXR file; at most 16384 pixels an edge. Errors: no such file, no OpenEXR file,
/// damaged, too large, without these channels.
Result<RadianceImage> readExr(const std::filesystem::path& path);

/// Scene-linear OpenEXR: R, G, B and error.R, error.G, error.B (standard error of the mean), float, with the provenance
/// as attributes.
Result<void> writeExr(const Film& film, const Provenance& provenance, const std::filesystem::path& path);

}  // namespace pdr
