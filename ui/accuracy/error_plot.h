#pragma once
/// A plot of the image's error against rendering time, both logarithmic. It shows the measured error with its band, the
/// course of independent samples (1 / sqrt(t)) for comparison, the target, and the forecast, hatched over its 95 %
/// interval. Setters emit no signals.

#include <QWidget>

#include "ui/accuracy/error_axes.h"
#include "ui/accuracy/plot_event.h"
#include "ui/text/accuracy_text.h"

namespace pdr::ui {

class ErrorPlot : public QWidget {
    Q_OBJECT

  public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    /// Sets the accuracy to show. `target`: the levels at which rendering stops.
    void setAccuracy(const Accuracy& accuracy, double target);
    double target() const { return target_; }
    /// Sets the events that changed the slope of the curve of the current image, in the order of time.
    void setEvents(const PlotEvents& events);
    /// Returns the axes at the current size of the plot.
    ErrorAxes axes() const;

    QSize sizeHint() const override { return {520, 150}; }
    QSize minimumSizeHint() const override { return {240, 90}; }

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void describe();
    void paintGrid(QPainter& painter, const ErrorAxes& axes) const;
    void paintTarget(QPainter& painter, const ErrorAxes& axes) const;
    void paintRootLine(QPainter& painter, const ErrorAxes& axes) const;
    void paintForecast(QPainter& painter, const ErrorAxes& axes) const;
    void paintMeasured(QPainter& painter, const ErrorAxes& axes) const;

    Accuracy accuracy_;
    PlotEvents events_;
    double target_ = kFinestStep;
};

}  // namespace pdr::ui
