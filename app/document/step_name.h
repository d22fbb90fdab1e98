#pragma once
/// What a step to undo is called, which follows from what it changed.

#include <QString>

#include "render/scene/picture_setup.h"

namespace pdr::app {

enum class Change {
    nothing,
    turned,
    moved,
    zoomed,
    lens,
    tableShown,
    tableHidden,
    lookChosen,
    tissue,
    light,
    visible,
    brightness,
    cut,
    model,
    rendering,
    several
};

/// What was done to `before` so that it became `after`. A look that was chosen brings its own brightness.
Change changeOf(const PictureSetup& before, const PictureSetup& after);

/// "Undo turning the view": a whole phrase, for a menu.
QString undoText(Change change);
/// "Redo turning the view".
QString redoText(Change change);

}  // namespace pdr::app
