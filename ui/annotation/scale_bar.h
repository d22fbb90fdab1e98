#pragma once
/// A bar of round length on the image, by which lengths are measured.

#include <QString>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

struct ScaleBar {
    double pixels = 0;  ///< length in the image
    QString text;       ///< "50 mm"; in perspective "50 mm at the centre's depth", since it is valid there alone
};

/// Returns the longest bar of 1, 2 or 5 times a power of ten millimetres that is at most `longest` pixels long, in an
/// image of `camera`'s view that is `height` pixels high. None: no such bar lies between 0.01 and 100,000 mm.
std::optional<ScaleBar> scaleBar(const Camera& camera, double height, double longest);

}  // namespace pdr::ui
