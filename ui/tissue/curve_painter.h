#pragma once
/// The parts of the tissue plot, painted one over the other: bands, histogram, the area below the curve, the curve and
/// its points, the axes.

#include <QColor>
#include <QLinearGradient>
#include <QPolygonF>
#include <vector>

#include "render/scene/edit/curve.h"
#include "render/scene/edit/tissue_channels.h"
#include "render/volume/value_unit.h"
#include "ui/tissue/plot_view.h"

class QPainter;
class QPalette;

namespace pdr::ui {

/// Returns the curve's outline from the left to the right edge of the view's area, with at most four points per pixel
/// column, however many points the curve has.
QPolygonF outlineOf(const Curve& curve, const PlotView& view);

/// Returns the albedo at `hu`; between the stops it is interpolated linearly, as light mixes.
vec3 albedoAt(const std::vector<ColourStop>& stops, double hu);
/// Returns the tissue's colours from the left to the right edge of the view.
QLinearGradient gradientOf(const std::vector<ColourStop>& stops, const PlotView& view);

/// Paints the tissue bands, and their names above the area where there is room.
void paintTissueBands(QPainter& painter, const PlotView& view, const QPalette& palette);
void paintHistogram(QPainter& painter, const PlotView& view, const std::vector<double>& bars, const QPalette& palette);
void paintCurve(QPainter& painter, const PlotView& view, const Curve& curve, const std::vector<ColourStop>& colours,
                const QPalette& palette);
void paintPoints(QPainter& painter, const PlotView& view, const Curve& curve, const CurveSelection& selection,
                 const QPalette& palette);
/// Paints the axes: below the area HU, or the values that `values` makes of voxels, and at its right the height of the
/// view times `unit`.
void paintAxes(QPainter& painter, const PlotView& view, double unit, const ValueUnit& values, const QPalette& palette);

}  // namespace pdr::ui
