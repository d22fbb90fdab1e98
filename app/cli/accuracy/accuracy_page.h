#pragma once
/// Accuracy report as one self-contained HTML file: plot, ladder (the times to reach error levels), table and images.

#include <filesystem>
#include <string>

#include "app/cli/accuracy/accuracy_report.h"

namespace pdr::app {

/// Returns the report as HTML. `images`: the folder of the steps' images; an image that cannot be read is left out.
std::string pageText(const AccuracyReport& report, const std::filesystem::path& images);

/// Returns the plot of an image alone, as an SVG file.
std::string plotText(const AccuracyImage& image);

}  // namespace pdr::app
