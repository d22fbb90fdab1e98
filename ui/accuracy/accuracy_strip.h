#pragma once
/// A slider along a time axis that shows what accuracy costs. It is filled up to now, has a tick where each step is or
/// will be reached, hatching over the 95 % intervals of the next step and the target, and a knob at the target, at
/// which rendering stops. Left is faster, right is more accurate. Setters emit no signals.

#include <QAbstractSlider>
#include <optional>

#include "ui/accuracy/strip_axis.h"
#include "ui/text/accuracy_text.h"

namespace pdr::ui {

class AccuracyStrip : public QAbstractSlider {
    Q_OBJECT

  public:
    explicit AccuracyStrip(QWidget* parent = nullptr);

    void setAccuracy(const Accuracy& accuracy);
    void setTarget(double levels);
    double target() const { return target_; }

    /// Returns the position of a step's tick [px]; none while it is not known.
    std::optional<double> tickOf(double levels) const;
    /// Returns the labels below the ticks, from left to right.
    std::vector<StripLabel> labels() const;

    QSize sizeHint() const override { return {400, minimumSizeHint().height()}; }
    QSize minimumSizeHint() const override;

  signals:
    void targetChosen(double levels);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QRectF track() const;
    double xOf(double seconds) const;
    double knob() const;
    QString labelOf(const QualityStep& step) const;
    void paintTrack(QPainter& painter) const;
    void paintBand(QPainter& painter, const QualityStep& step) const;
    void paintTicks(QPainter& painter) const;
    void paintKnob(QPainter& painter) const;
    std::vector<QualityStep> marks() const;
    void choose(double x);
    void take(double levels);
    void describe();

    Accuracy accuracy_;
    StripAxis axis_;
    double target_ = kFinestStep;  ///< [levels], at or between the steps; value() is the step at or before it
};

}  // namespace pdr::ui
