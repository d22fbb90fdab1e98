#pragma once
/// What is written over the PNG files of the command line.

#include <optional>

#include "app/cli/scene_input.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Whether `arguments`, which begin with the command, may end in an image with letters, which takes a QGuiApplication.
bool mayWriteLetters(int argc, const char* const* argv);

/// Errors: letters are wanted, and this machine has no font.
Result<void> checkFonts(ui::Annotate wanted);

/// Errors: the patient is wanted, and the voxels are of a raw file, which knows none.
Result<std::optional<ui::Annotations>> annotationsOf(const LoadedScene& loaded, ui::Annotate wanted);

}  // namespace pdr::app
