#pragma once
/// The strip of the tissue's colours along Hounsfield units, with handles for its stops below. Ctrl and a press, or
/// Ins, adds a stop; Enter or a double click on one opens a colour dialog. Setters emit no signals.

#include "render/scene/edit/tissue_channels.h"
#include "render/volume/value_unit.h"
#include "ui/tissue/points_plot.h"

namespace pdr::ui {

class ColourStrip : public PointsPlot {
    Q_OBJECT

  public:
    explicit ColourStrip(QWidget* parent = nullptr);

    const std::vector<ColourStop>& stops() const { return stops_; }
    void setStops(const std::vector<ColourStop>& stops);
    /// Changes the colour of a stop as the user does: emits edited(moving). Does nothing if there is no such stop.
    void setColour(std::size_t stop, const QColor& colour, bool moving);
    /// Sets the unit of the values along the strip; HU at first.
    void setValues(const ValueUnit& values);
    /// Sets the plot's distances from the widget's left and right edges [px], which align it with the plot above.
    void setMargins(int left, int right);

    QSize sizeHint() const override { return {300, 34}; }
    QSize minimumSizeHint() const override { return {200, 34}; }

  public slots:
    /// Opens a colour dialog. Each colour tried in it is emitted as an edit; cancelling restores the colour.
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
    QString placeText(double voxel) const;

    std::vector<ColourStop> stops_{ColourStop{}};
    int left_ = 0, right_ = 0;
    ValueUnit values_;
};

}  // namespace pdr::ui
