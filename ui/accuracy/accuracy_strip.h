#pragma once
/// What accuracy costs, along a time axis: filled up to now, a tick where each step is or will be reached, hatched
/// where the next one and the target lie to 95 %, and a knob at the target, at which rendering holds. Left is faster,
/// right more accurate. Setters are silent.

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

    /// Where the tick of that step stands [px]; nothing while it is not known.
    std::optional<double> tickOf(double levels) const;
    /// What stands below the ticks, from left to right.
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
    double target_ = kFinestStep;  ///< at or between the steps; value() is the step at or before it
};

}  // namespace pdr::ui
