#pragma once
/// Texts that describe cuts.

#include <QString>
#include <optional>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

/// Returns the name of a side of the box: "front".
QString faceName(int face);
/// Returns the orientation of a plane: "Coronal", "Coronal, tilted by 12°".
QString planeName(const ClipPlane& plane);
/// Returns the effect of a handle: "front: 31.5 mm cut off".
QString handleText(const Clip& clip, const Uncut& uncut, CutHandle handle);

/// Returns all cuts: "cut: front 47.1 mm; Coronal: 12.0 mm from the middle; 1 drawn". Empty: nothing is cut. If `uncut`
/// is not known, a box is described by its size and a plane by its name.
QString cutText(const Clip& clip, const std::optional<Uncut>& uncut);

}  // namespace pdr::ui
