#pragma once
/// A ball that is lit as the volume is, with a handle for each lamp: over the ball where it shines from the viewer's
/// side, in the ring about it where it shines from behind. Setters are silent.

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "render/base/portable.h"

namespace pdr::ui {

/// A lamp as the viewer sees it.
struct SphereLamp {
    QString name;
    dvec3 from;         ///< where it stands, unit: to the right, up, towards the viewer
    double irradiance;  ///< of the ball's middle
    vec3 colour;        ///< linear Rec. 709
};

class LightSphere : public QWidget {
    Q_OBJECT

  public:
    explicit LightSphere(QWidget* parent = nullptr);

    /// What is held stays held; see letGo().
    void setLamps(const std::vector<SphereLamp>& lamps);
    void setCurrent(int index);
    /// Whatever is held: the drag does nothing more.
    void letGo();
    /// The lamp that keys move; -1: there is none.
    int current() const { return lamps_.empty() ? -1 : current_; }
    /// That lamp; there must be one.
    const SphereLamp& lamp() const { return lamps_[std::size_t(current_)]; }

    /// Where a lamp's handle is, and which direction a place of the widget stands for.
    QPointF handleOf(dvec3 from) const;
    dvec3 directionAt(QPointF place) const;

    QSize sizeHint() const override { return {190, 170}; }
    QSize minimumSizeHint() const override { return {140, 140}; }

  signals:
    void currentChanged(int index);
    /// A lamp was taken to `from`. `moving`: the gesture goes on; the last one of a gesture comes with false.
    void lampMoved(int index, pdr::dvec3 from, bool moving);
    /// The ball was dragged beside all handles, by so much of its diameter: all lamps are to turn.
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
    QImage ball(double pixels) const;
    void paintHandle(QPainter& painter, int index) const;

    std::vector<SphereLamp> lamps_;
    QImage ball_;  ///< null: to be painted anew
    int current_ = 0;
    bool held_ = false;     ///< the current lamp, by the mouse
    bool turning_ = false;  ///< all lamps
    QPointF last_;
};

}  // namespace pdr::ui
