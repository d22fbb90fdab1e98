#pragma once
/// The gallery's cards, and the requests for their small images.

#include "app/document/document.h"
#include "app/jobs/look_images.h"
#include "ui/looks/look_gallery.h"

namespace pdr::app {

/// Returns the gallery's cards, in the document's order.
QList<ui::LookCard> lookCards(const Document& document);

/// Returns the requests for small images: first the look that is shown, since its brightness is awaited; then those
/// that suit the scan.
std::vector<LookTask> lookTasks(const Document& document);

}  // namespace pdr::app
