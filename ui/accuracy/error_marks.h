#pragma once
/// Marks in the plot of the error where nodes came or went: a triangle up at the lower edge, or one down, hollow, and a
/// faint line through the plot; what happened there; and what the marks mean.

#include <QPainter>
#include <QPalette>

#include "ui/accuracy/error_axes.h"
#include "ui/accuracy/plot_event.h"

namespace pdr::ui {

void paintMarks(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette);
/// A line at the upper right of the plot, of the kinds that there are.
void paintMarkLegend(QPainter& painter, const ErrorAxes& axes, const PlotEvents& events, const QPalette& palette);
/// What happened near that place, a line each; empty: nothing did.
QString marksAt(QPointF place, const ErrorAxes& axes, const PlotEvents& events);

}  // namespace pdr::ui
