#pragma once
/// What the window shows, as a file: PNG with its caption, or OpenEXR, both with their provenance.

#include <QString>
#include <stop_token>

#include "render/session/session.h"

namespace pdr::app {

/// Errors: the end of the name says no format, which is ".png" or ".exr".
Result<void> checkPictureName(const QString& file);

/// Writes the film of `view` in the format that the name's end says; an unfinished PNG says so where it is
/// `captioned`. Any thread's. Errors: those of writePng() and writeExr(); cancelled() after a stop request.
Result<void> writePicture(const FilmView& view, Display display, bool captioned, const QString& file,
                          const std::stop_token& stop = {});

/// `reason` as the reason why there is no `file`.
Error notSaved(const QString& file, const Error& reason);

}  // namespace pdr::app
