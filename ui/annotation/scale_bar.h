#pragma once
/// A line of a round length beside an image, by which lengths in it are read.

#include <QString>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

struct ScaleBar {
    double pixels = 0;  ///< along the image
    QString text;       ///< "50 mm"; in perspective "50 mm at the centre's depth", since it holds there alone
};

/// The longest bar of 1, 2 or 5 times a power of ten millimetres that is at most `longest` pixels long, in an image of
/// `camera`'s view that is `height` pixels high. None: there is no such bar between 0.01 and 100,000 mm.
std::optional<ScaleBar> scaleBar(const Camera& camera, double height, double longest);

}  // namespace pdr::ui
