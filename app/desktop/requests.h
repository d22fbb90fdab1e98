#pragma once
/// Requests of the user that involve several parts of the desktop.

#include <QColor>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Finds the tissue at `place`, in fractions of the image's width and height.
void pickTissue(const DesktopParts& parts, QPointF place);
/// Finds the depth of what lies at `place`, in fractions of the image's width and height, and focuses there.
void pickFocus(const DesktopParts& parts, QPointF place);
/// Sets the background to `colour` as the screen shows it; none: the environment.
void setBackground(const DesktopParts& parts, const std::optional<QColor>& colour);
/// Changes the optical model, and measures how it compares with the one before.
void chooseModel(const DesktopParts& parts, Model model);
/// Renders the requested image to a file, in parallel with the session.
void makePicture(const DesktopParts& parts, const ui::PictureOrder& order);
/// Writes the image on the screen to `file`.
void savePicture(const DesktopParts& parts, const QString& file, ui::Annotate annotate);
/// Cancels what the progress bar shows: the import, the mask of a body part or an environment image that is read, or
/// else an image that is rendered to a file.
void cancelWhatRuns(const DesktopParts& parts);
/// Gives the film the view's size if its image is still coarse. Otherwise the image keeps its samples and is scaled
/// until another one begins.
void keepOrFitFilm(const DesktopParts& parts);
/// Gives the film the view's size; the image begins anew if that differs.
void fitFilm(const DesktopParts& parts);
/// Leaves out the effects that nobody would see, as the panel of effects offers.
void leaveOutUnseen(const DesktopParts& parts);

}  // namespace pdr::app
