#pragma once
/// Writes the image of the window to a file: PNG with its annotations, or OpenEXR, both with their provenance.

#include <QString>
#include <optional>
#include <stop_token>

#include "render/film/file/image_file.h"
#include "render/session/session.h"
#include "render/tiles/node_checks.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Checks the extension of `file`. Error: it is neither ".png" nor ".exr".
Result<void> checkImageName(const QString& file);

/// Writes the film of `view` in the format of the file's extension. A PNG carries `annotations`, if there are any, and
/// with them whether the image is unfinished; OpenEXR carries none. `checks`: those of the samples of render nodes. May
/// be called on any thread. Errors: those of writePng() and writeExr(); cancelled() after a stop request.
Result<void> writeImage(const FilmView& view, Display display, const std::optional<ui::Annotations>& annotations,
                        const QString& file, const NodeChecks& checks = {}, const std::stop_token& stop = {});

/// Returns an error that gives `reason` as the reason why `file` was not saved.
Error notSaved(const QString& file, const Error& reason);

}  // namespace pdr::app
