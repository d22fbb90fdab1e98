#pragma once
/// Annotations over the images of the window, on the screen, in saved files and on the clipboard.

#include <optional>

#include "app/presenters/workspace.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

/// Returns the annotations of `frame`: its view, look, visible part and cut, and the patient's lines as far as the
/// window shows them.
ui::Annotations annotationsOf(const Workspace& workspace, const Frame& frame);
/// Returns the annotations of an image that is still to be rendered from `scene`, the document's scene but for its
/// film.
ui::Annotations annotationsOf(const Workspace& workspace, const Scene& scene);

/// Returns the annotations of `all` that an image carries when it leaves the window; none for Annotate::none.
std::optional<ui::Annotations> leaving(ui::Annotations all, ui::Annotate choice);

}  // namespace pdr::app
