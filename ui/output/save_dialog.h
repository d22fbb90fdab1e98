#pragma once
/// The dialog that asks where an image goes, how large it is and how accurate.

#include <QAction>
#include <QWidget>
#include <optional>

#include "ui/output/picture_order.h"

namespace pdr::ui {

/// Asks for a file to save the picture in, for its size, for how good it is to be and what is written over it,
/// beginning with `offer`. None: the user cancelled, or `save` was disabled meanwhile: a name that was thought of for
/// one patient must not go to the next.
std::optional<PictureOrder> askForPicture(QWidget* parent, const QAction& save, const PictureOffer& offer);

}  // namespace pdr::ui
