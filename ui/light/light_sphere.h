#pragma once
/// A ball lit as the volume is, with a handle for each lamp: over the ball if the lamp is on the viewer's side, in the
/// ring around it if it is behind. Setters emit no signals.

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/light/lit_ball.h"

namespace pdr::ui {

class LightSphere : public QWidget {
    Q_OBJECT

  public:
    explicit LightSphere(QWidget* parent = nullptr);

    /// Sets the lamps. A drag goes on; see letGo().
    void setLamps(const std::vector<SphereLamp>& lamps);
    void setCurrent(int index);
    /// Ends the drag in progress.
    void letGo();
    /// Returns the lamp that keys move; -1: there is none.
    int current() const { return lamps_.empty() ? -1 : current_; }
    /// Returns the current lamp; there must be one.
    const SphereLamp& lamp() const { return lamps_[std::size_t(current_)]; }

    /// Return the place of a lamp's handle, and the direction that a place of the widget stands for.
    QPointF handleOf(dvec3 from) const;
    dvec3 directionAt(QPointF place) const;

    QSize sizeHint() const override { return {190, 170}; }
    QSize minimumSizeHint() const override { return {140, 140}; }

  signals:
    void currentChanged(int index);
    /// Reports that a lamp was moved to the direction `from`. `moving`: the gesture goes on; the last one of a gesture
    /// comes with false.
    void lampMoved(int index, pdr::dvec3 from, bool moving);
    /// Requests to turn all lamps: the ball was dragged beside all handles, by `drag` in fractions of its diameter.
    void allTurned(pdr::dvec2 drag, bool moving);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    double ringRadius() const;
    double ballRadius() const;
    QPointF middle() const;
    int lampAt(QPointF place) const;
    void choose(int index);
    void moveBy(dvec2 degrees);
    void paintHandle(QPainter& painter, int index) const;

    std::vector<SphereLamp> lamps_;
    QImage ball_;  ///< null: must be painted anew
    int current_ = 0;
    bool held_ = false;     ///< the mouse drags the current lamp
    bool turning_ = false;  ///< the mouse turns all lamps
    QPointF last_;
};

}  // namespace pdr::ui
