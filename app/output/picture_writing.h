#pragma once
/// What the window shows, as a file: PNG with its annotations, or OpenEXR, both with their provenance.

#include <QString>
#include <optional>
#include <stop_token>

#include "render/film/file/image_file.h"
#include "render/session/session.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Errors: the end of the name says no format, which is ".png" or ".exr".
Result<void> checkPictureName(const QString& file);

/// Writes the film of `view` in the format that the name's end says. A PNG carries `annotations`, if there are any, and
/// with them whether it is unfinished; OpenEXR carries none. Any thread's. Errors: those of writePng() and writeExr();
/// cancelled() after a stop request.
Result<void> writePicture(const FilmView& view, Display display, const std::optional<ui::Annotations>& annotations,
                          const QString& file, const std::stop_token& stop = {});

/// `reason` as the reason why there is no `file`.
Error notSaved(const QString& file, const Error& reason);

}  // namespace pdr::app
