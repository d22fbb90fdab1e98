#pragma once
/// The files that a rendering ends in: looked at before it begins, and written so that none is lost with another.

#include <filesystem>
#include <vector>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/film/image_file.h"

namespace pdr::app {

using Paths = std::vector<std::filesystem::path>;

/// Nobody should wait for a picture that cannot be written. Errors: those of ReplacingFile::open().
Result<void> checkWritable(const Paths& outputs);
/// Errors: one of `outputs` is, by whatever name, one of `inputs`.
Result<void> checkSpared(const Paths& inputs, const Paths& outputs);

struct WrittenFiles {
    Paths files;                  ///< where the pictures are
    std::vector<Error> troubles;  ///< one for each output that is not where it was asked for
};

/// Writes every output, PNG or OpenEXR by its extension. One that fails is tried under a free name beside its place
/// ("head-2.png"), then in the current folder. `view` has judged the film where a smoothed picture is wanted.
/// `paintOver`: for PNG files.
WrittenFiles writePictures(const Film& film, const Display& display, SmoothedView& view, const Provenance& facts,
                           const PaintOver& paintOver, const Paths& outputs);

}  // namespace pdr::app
