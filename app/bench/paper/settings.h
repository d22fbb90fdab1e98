#pragma once
/// The words after "pdrender-bench paper".

#include <filesystem>
#include <optional>
#include <string>

#include "app/bench/commands.h"
#include "app/bench/paper/plan.h"
#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::bench::paper {

struct Settings {
    std::string sceneFile;  ///< empty: the head
    std::string device = "cpu";
    int threads = 0;                           ///< of the CPU; 0 = one per core
    std::optional<std::filesystem::path> out;  ///< an existing folder
    std::optional<Estimator> estimator;        ///< nothing: the scene's own
    Plan plan;
};

/// Errors: a word that is none of the command's, a value out of its range, no such folder and none to be made.
Result<Settings> settingsFrom(const Arguments& arguments);

}  // namespace pdr::bench::paper
