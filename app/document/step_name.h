#pragma once
/// The name of a step to undo, derived from what the step changed.

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
    background,
    cut,
    model,
    rendering,
    several
};

/// Returns the kind of change that turned `before` into `after`. Choosing a look includes its brightness.
Change changeOf(const PictureSetup& before, const PictureSetup& after);

/// Returns a whole phrase for a menu: "Undo turning the view".
QString undoText(Change change);
/// Returns a whole phrase for a menu: "Redo turning the view".
QString redoText(Change change);

}  // namespace pdr::app
