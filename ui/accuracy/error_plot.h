#pragma once
/// How the picture's error has fallen and will fall: error against time, both logarithmic. What was measured with its
/// band, the way of independent samples (1 / sqrt(t)) to compare with, the target, and what is foretold, hatched where
/// it lies to 95 %. Setters are silent.

#include <QWidget>

#include "ui/accuracy/error_axes.h"
#include "ui/accuracy/plot_event.h"
#include "ui/text/accuracy_text.h"

namespace pdr::ui {

class ErrorPlot : public QWidget {
    Q_OBJECT

  public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    /// `target`: the levels at which rendering holds.
    void setAccuracy(const Accuracy& accuracy, double target);
    double target() const { return target_; }
    /// What bent the curve, in the order of time; of the picture in hand.
    void setEvents(const PlotEvents& events);
    /// Of the plot as it is large now.
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
