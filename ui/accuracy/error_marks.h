#pragma once
/// Marks in the error plot for render nodes that joined or were lost, the legend of these marks, and the text of each.

#include <QPainter>
#include <QPalette>

#include "ui/accuracy/error_axes.h"
#include "ui/accuracy/plot_event.h"

namespace pdr::ui {

/// Paints a mark for each event: at the lower edge a filled triangle that points up (joined) or a hollow one that
/// points down (lost), and a faint line through the plot.
void paintMarks(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette);
/// Paints the legend in one line at the upper right of the plot, with the kinds of marks that occur.
void paintMarkLegend(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette);
/// Returns the texts of the events near `place`, one per line; empty if there are none.
QString marksAt(QPointF place, const ErrorAxes& axes, const PlotEvents& events);

}  // namespace pdr::ui
