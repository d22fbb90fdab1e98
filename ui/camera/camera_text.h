#pragma once
/// The lens in words.

#include <QString>

#include "render/scene/camera.h"

namespace pdr::ui {

/// "Sharp from 31 mm before the focus to 34 mm behind it; the focus is 812 mm away."
QString sharpText(const Camera& camera);

}  // namespace pdr::ui
