#pragma once
/// A text that describes the depth of field.

#include <QString>

#include "render/scene/camera.h"

namespace pdr::ui {

/// Returns the range that is in focus: "Sharp from 31 mm before the focus to 34 mm behind it; it is 812 mm away."
QString sharpText(const Camera& camera);

}  // namespace pdr::ui
