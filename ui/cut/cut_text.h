#pragma once
/// Cuts in words.

#include <QString>

#include "render/scene/cut_handles.h"

namespace pdr::ui {

/// A side of the box: "front".
QString faceName(int face);
/// How a plane lies: "Coronal", "Coronal, tilted by 12°".
QString planeName(const ClipPlane& plane);
/// What a handle has done: "31.5 mm cut off at the front".
QString handleText(const Clip& clip, const Uncut& uncut, CutHandle handle);

}  // namespace pdr::ui
