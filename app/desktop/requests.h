#pragma once
/// What the user asks of several parts at once.

#include <QColor>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// What the click on the picture asks for: what lies there.
void pickTissue(const DesktopParts& parts, QPointF place);
/// What the click on the picture asks for: how far away that is.
void pickFocus(const DesktopParts& parts, QPointF place);
/// Puts that colour behind the volume, as the screen shows it; none: what lights it from all around.
void setBackground(const DesktopParts& parts, const std::optional<QColor>& colour);
/// Another model, and how it compares with the one before, as soon as it is known.
void chooseModel(const DesktopParts& parts, Model model);
/// Makes the picture that was ordered beside the session.
void makePicture(const DesktopParts& parts, const ui::PictureOrder& order);
/// Writes the picture that is on the screen.
void savePicture(const DesktopParts& parts, const QString& file, ui::Annotate annotate);
/// Gives up what the progress is shown of: reading, looking for a part of the body, a picture of surroundings, or else
/// a picture that is being made.
void cancelWhatRuns(const DesktopParts& parts);
/// The film takes the view's size where its image is still coarse; one with samples worth keeping stays, and is scaled
/// until something begins a new one.
void keepOrFitFilm(const DesktopParts& parts);
/// The film takes the view's size, and begins anew where that is another one.
void fitFilm(const DesktopParts& parts);
/// Does what the panel of effects offers.
void leaveOutUnseen(const DesktopParts& parts);

}  // namespace pdr::app
