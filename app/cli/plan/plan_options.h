#pragma once
/// Options of `pdrender-cli plan`.

#include <QStringList>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/render/render_options.h"
#include "render/base/result.h"

namespace pdr::app {

struct PlanOptions {
    std::filesystem::path file;                 ///< the plan
    std::filesystem::path scan;                 ///< a DICOM folder or a scene file; empty: the scan is not at hand
    std::string seriesUid;                      ///< empty: the first series that can be loaded
    std::vector<std::filesystem::path> tables;  ///< files for other programs; each .csv or .mrk.json
    std::filesystem::path labels;               ///< the label map that the plan shows; empty: none is at hand
    std::optional<RenderOptions> image;         ///< the images to render, and how; their scene has a size alone
    bool json = false;
    bool help = false;
};

/// Parses the arguments after the word `plan`. Errors are usage errors and name the option in `where`.
Result<PlanOptions> planOptions(const QStringList& arguments);

/// Returns the text for --help.
std::string planHelp();

}  // namespace pdr::app
