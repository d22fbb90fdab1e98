#pragma once
/// The output files of a render: checked before it begins, and written so that a failure of one does not lose another.

#include <filesystem>
#include <functional>
#include <vector>

#include "render/base/result.h"

namespace pdr::app {

using Paths = std::vector<std::filesystem::path>;

/// Checks that all outputs can be written, before the render begins. Errors: those of ReplacingFile::open().
Result<void> checkWritable(const Paths& outputs);
/// Checks that no output overwrites an input, by whatever name. Error: one does.
Result<void> checkSpared(const Paths& inputs, const Paths& outputs);
/// Returns whether one of `outputs` is a PNG file, by its extension.
bool anyPng(const Paths& outputs);

struct WrittenFiles {
    Paths files;                  ///< files that contain the images
    std::vector<Error> troubles;  ///< one for each output that could not be written in its place
};

/// Calls `write` for every output. An output that fails is tried under a free name beside its place ("head-2.png"),
/// then in the current folder, unless `write` was cancelled.
WrittenFiles writeFiles(const Paths& outputs, const std::function<Result<void>(const std::filesystem::path&)>& write);

}  // namespace pdr::app
