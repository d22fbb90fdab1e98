#pragma once
/// What the user asks of several parts at once.

#include "app/desktop_parts.h"

namespace pdr::app {

/// What the click on the picture asks for: what lies there.
void pickTissue(const DesktopParts& parts, QPointF place);
/// Makes the picture that was ordered beside the session.
void makePicture(const DesktopParts& parts, const ui::PictureOrder& order);
/// Gives up what the progress is shown of: reading, looking for a part of the body, or else a
/// picture that is being made.
void cancelWhatRuns(const DesktopParts& parts);
/// Does what the panel of effects offers.
void leaveOutUnseen(const DesktopParts& parts);

}  // namespace pdr::app
