#pragma once
/// The parts of the tissue plot, one painted over the other: bands, histogram, what lies below the curve, the curve and
/// its points, the axes.

#include <QColor>
#include <QLinearGradient>
#include <QPolygonF>
#include <vector>

#include "render/scene/edit/curve.h"
#include "render/scene/edit/tissue_channels.h"
#include "ui/tissue/plot_view.h"

class QPainter;
class QPalette;

namespace pdr::ui {

/// The curve from edge to edge of the view's area. At most four places for each pixel column, however many points.
QPolygonF outlineOf(const Curve& curve, const PlotView& view);

/// Between the stops colours are mixed as light is.
vec3 albedoAt(const std::vector<ColourStop>& stops, double hu);
/// The tissue's colours from edge to edge.
QLinearGradient gradientOf(const std::vector<ColourStop>& stops, const PlotView& view);

/// With their names above the area, as far as there is room.
void paintTissueBands(QPainter& painter, const PlotView& view, const QPalette& palette);
void paintHistogram(QPainter& painter, const PlotView& view, const std::vector<double>& bars, const QPalette& palette);
void paintCurve(QPainter& painter, const PlotView& view, const Curve& curve, const std::vector<ColourStop>& colours,
                const QPalette& palette);
void paintPoints(QPainter& painter, const PlotView& view, const Curve& curve, const CurveSelection& selection,
                 const QPalette& palette);
/// HU below the area. Values at its right: those of the view times `unit`.
void paintAxes(QPainter& painter, const PlotView& view, double unit, const QPalette& palette);

}  // namespace pdr::ui
