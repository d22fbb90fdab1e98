#pragma once
/// Options of `pdrender-bench paper`.

#include <filesystem>
#include <optional>
#include <string>

#include "app/bench/commands.h"
#include "app/bench/paper/plan.h"
#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench::paper {

struct Settings {
    std::string sceneFile;  ///< path of the scene file; empty: the head
    std::string device = "cpu";
    int threads = 0;                           ///< CPU threads; 0: one per core
    std::optional<std::filesystem::path> out;  ///< existing folder for results; null: none
    std::optional<Estimator> estimator;        ///< null: the scene's own
    Plan plan;
};

/// Parses `arguments`. Errors: an unknown word, a value out of its range, a folder that does not exist and cannot be
/// made.
Result<Settings> settingsFrom(const Arguments& arguments);

}  // namespace pdr::bench::paper
