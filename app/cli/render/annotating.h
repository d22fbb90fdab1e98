#pragma once
/// Annotations that the command line paints over PNG files.

#include <optional>

#include "app/cli/scene/scene_input.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Returns whether the command line may end in an image with letters, which requires a QGuiApplication. `argv[1]` is
/// the command.
bool mayWriteLetters(int argc, const char* const* argv);

/// Checks that this machine has a font if `wanted` requires letters. Errors: there is none.
Result<void> checkFonts(ui::Annotate wanted);

/// Returns the error that the patient's data is requested and the voxels come from a raw file.
Error noPatientKnown();

/// Returns the annotations of an image; null if none are requested. Errors: the patient's data is requested and the
/// voxels come from a raw file, which has none.
Result<std::optional<ui::Annotations>> annotationsOf(const LoadedScene& loaded, ui::Annotate wanted);

}  // namespace pdr::app
