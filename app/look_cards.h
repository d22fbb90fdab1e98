#pragma once
/// The document's looks as the gallery shows them.

#include <vector>

#include "app/document.h"
#include "app/look_pictures.h"
#include "ui/look_gallery.h"

namespace pdr::app {

/// In the document's order.
QList<ui::LookCard> cardsOf(const Document& document);

/// The pictures that the gallery needs: those that make sense of the scan first. The document has a volume.
std::vector<LookTask> tasksOf(const Document& document);

}  // namespace pdr::app
