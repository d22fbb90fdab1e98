#pragma once
/// What the slices show: one place of the patient that all views agree on, how each slice is framed, the window through
/// which they are seen, and where they are beside the image.

#include <array>

#include "render/base/portable.h"
#include "render/slice/grey_window.h"
#include "render/slice/view_layout.h"

namespace pdr::app {

/// How a slice lies in its view.
struct SliceFraming {
    double zoom = 1;    ///< magnification; 1: the whole slice fits the view; [kLeastZoom, kGreatestZoom]
    dvec2 panMm{0, 0};  ///< place in the middle of the view, from the slice's middle: to the right and down
    bool operator==(const SliceFraming&) const = default;

    static constexpr double kLeastZoom = 0.25, kGreatestZoom = 64;
};

struct Navigation {
    dvec3 crosshairMm{0};                  ///< in the patient (LPS); each slice contains it
    std::array<SliceFraming, 3> framings;  ///< in the order of kAnatomicalPlanes
    GreyWindow window;
    ViewLayout layout = ViewLayout::image;
    bool operator==(const Navigation&) const = default;
};

}  // namespace pdr::app
