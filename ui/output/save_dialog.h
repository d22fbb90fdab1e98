#pragma once
/// The dialog that asks where to save an image, at which size, and how accurate it must be.

#include <QAction>
#include <QWidget>
#include <optional>

#include "ui/output/image_order.h"

namespace pdr::ui {

/// Asks for a file to save the image in, and for its size, accuracy and annotations, beginning with `offer`. None: the
/// user cancelled, or `save` was disabled meanwhile, since a name proposed for one patient must not be used for the
/// next.
std::optional<ImageOrder> askForImage(QWidget* parent, const QAction& save, const ImageOffer& offer);

}  // namespace pdr::ui
