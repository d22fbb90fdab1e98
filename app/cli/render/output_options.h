#pragma once
/// Options of all commands that write images: where to, and what is written over them.

#include <QCommandLineParser>

#include <filesystem>
#include <vector>

#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Reads the paths of `--output`, at least one, each ending in .png or .exr. Throws an Error for the first wrong one.
std::vector<std::filesystem::path> readOutputs(const QCommandLineParser& parser);

/// Reads `--annotations`. Throws an Error if its word is not known.
ui::Annotate readAnnotate(const QCommandLineParser& parser);

}  // namespace pdr::app
