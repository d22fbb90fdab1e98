#pragma once
/// A slice on the screen, and the painting of it. Everything that is painted over the pixels follows from the plane
/// with which they were computed, so that no letter or scale can belong to another slice.

#include <QImage>
#include <QPainter>
#include <QStringList>
#include <optional>

#include "render/slice/slice_stack.h"

namespace pdr::ui {

struct ShownSlice {
    QImage image;       ///< the pixels of `plane`; a coarse slice's: of halved(plane)
    SlicePlane plane;   ///< in screen pixels of the view
    QStringList texts;  ///< what the slice is, a line each: "Axial 51 of 100", "Window 350 / 50 HU"
    /// Directions of the lines in which the other planes cut this one, in pixels: the one from side to side, the one
    /// from top to bottom. A tilted gantry turns them against the edges.
    dvec2 lineAcross{1, 0}, lineDown{0, 1};

    /// Returns whether the slice has half of its plane's resolution, because something moves.
    bool isCoarse() const { return image.width() < plane.size.x; }
};

/// Paints `slice` into a view of `size` [px] with letters, scale bar and texts. A slice of another size, while the one
/// that fits is computed, is stretched; so is a coarse one, whose places do not move.
void paintSlice(QPainter& painter, const ShownSlice& slice, const QSize& size);

/// Paints the two lines in which the other planes through `placeMm` cut `slice`, which lies in `plane`, with a gap
/// around the place itself.
void paintCrosshair(QPainter& painter, const ShownSlice& slice, AnatomicalPlane plane, dvec3 placeMm,
                    const QSize& size);

}  // namespace pdr::ui
