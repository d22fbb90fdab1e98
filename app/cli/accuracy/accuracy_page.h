#pragma once
/// The report as one HTML file that needs nothing else: plot, ladder, table and pictures.

#include <filesystem>
#include <string>

#include "app/cli/accuracy/accuracy_report.h"

namespace pdr::app {

/// `pictures`: the folder that the steps' pictures lie in; one that cannot be read is left out.
std::string pageText(const AccuracyReport& report, const std::filesystem::path& pictures);

/// Its plot alone, as an SVG file.
std::string plotText(const AccuracyPicture& picture);

}  // namespace pdr::app
