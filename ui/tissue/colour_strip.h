#pragma once
/// The tissue's colours along Hounsfield units, with stops of their own below. Ctrl and a press, or Ins, adds a stop;
/// Enter or a double click on one asks for its colour. Setters are silent.

#include "render/scene/edit/tissue_channels.h"
#include "ui/tissue/points_plot.h"

namespace pdr::ui {

class ColourStrip : public PointsPlot {
    Q_OBJECT

  public:
    explicit ColourStrip(QWidget* parent = nullptr);

    const std::vector<ColourStop>& stops() const { return stops_; }
    void setStops(const std::vector<ColourStop>& stops);
    /// As the hand does it: emits edited(moving). No stop of that number: nothing happens.
    void setColour(std::size_t stop, const QColor& colour, bool moving);
    /// How far from the widget's left and right side the plot begins, so that it stands below another one.
    void setMargins(int left, int right);

    QSize sizeHint() const override { return {300, 34}; }
    QSize minimumSizeHint() const override { return {200, 34}; }

  public slots:
    /// Shows a dialog; edits follow while a colour is looked for, and go back where none is chosen.
    void askForColour(std::size_t stop);

  protected:
    CurvePoint step() const override;
    QString tipAt(QPointF place) const override;
    void pointAdded(std::size_t index) override;
    void pointsRemoved(const CurveSelection& removed) override;
    void pointsMoved() override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void layOut();
    void describe();

    std::vector<ColourStop> stops_{ColourStop{}};
    int left_ = 0, right_ = 0;
};

}  // namespace pdr::ui
