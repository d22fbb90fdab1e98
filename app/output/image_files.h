#pragma once
/// The files that a rendering ends in: looked at before it begins, and written so that none is lost with another.

#include <filesystem>
#include <functional>
#include <vector>

#include "render/base/result.h"

namespace pdr::app {

using Paths = std::vector<std::filesystem::path>;

/// Nobody should wait for an image that cannot be written. Errors: those of ReplacingFile::open().
Result<void> checkWritable(const Paths& outputs);
/// Errors: one of `outputs` is, by whatever name, one of `inputs`.
Result<void> checkSpared(const Paths& inputs, const Paths& outputs);
/// Whether one of them is PNG, by its ending.
bool anyPng(const Paths& outputs);

struct WrittenFiles {
    Paths files;                  ///< where the images are
    std::vector<Error> troubles;  ///< one for each output that is not where it was asked for
};

/// Calls `write` for every output. One that fails is tried under a free name beside its place ("head-2.png"), then in
/// the current folder, unless `write` was cancelled.
WrittenFiles writeFiles(const Paths& outputs, const std::function<Result<void>(const std::filesystem::path&)>& write);

}  // namespace pdr::app
