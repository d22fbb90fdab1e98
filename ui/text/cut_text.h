#pragma once
/// Cuts in words.

#include <QString>
#include <optional>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

/// A side of the box: "front".
QString faceName(int face);
/// How a plane lies: "Coronal", "Coronal, tilted by 12°".
QString planeName(const ClipPlane& plane);
/// What a handle has done: "31.5 mm cut off at the front".
QString handleText(const Clip& clip, const Uncut& uncut, CutHandle handle);

/// All of a cut: "cut: front 47.1 mm; Coronal: 12.0 mm from the middle; 1 drawn". Empty: nothing is cut. Where what it
/// cuts from is not known a box has its size, and a plane its name.
QString cutText(const Clip& clip, const std::optional<Uncut>& uncut);

}  // namespace pdr::ui
