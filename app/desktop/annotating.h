#pragma once
/// What is written over the images of the window, on the screen and where they leave it.

#include <optional>

#include "app/desktop/desktop_parts.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// What is said of `frame`: its own view, look, part and cut, and who the patient is, as far as the window says it.
ui::Annotations annotationsOf(const DesktopParts& parts, const Frame& frame);
/// What is said of an image that is still to be made of `scene`: the document's own but for its film.
ui::Annotations annotationsOf(const DesktopParts& parts, const Scene& scene);

/// What of `all` an image carries that leaves the window.
std::optional<ui::Annotations> leaving(ui::Annotations all, ui::Annotate choice);
/// What it carries where nobody is asked.
ui::Annotate usualAnnotate(const DesktopParts& parts);

}  // namespace pdr::app
