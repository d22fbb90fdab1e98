#pragma once
/// The panel that shows and edits the tissue's optical properties over Hounsfield units: one curve at a time over this
/// patient's histogram, the colours below it, and the exact numbers. Setters emit no signals.

#include <QCheckBox>
#include <QPushButton>
#include <memory>

#include "ui/tissue/colour_strip.h"
#include "ui/tissue/curve_editor.h"
#include "ui/tissue/point_row.h"
#include "ui/tissue/shape_row.h"

namespace pdr::ui {

class TissuePanel : public QWidget {
    Q_OBJECT

  public:
    explicit TissuePanel(QWidget* parent = nullptr);

    /// Sets the transfer function. One that differs from the user's last edit ends that edit, and is shown as free
    /// points.
    void setTransferFunction(const TransferFunction& function);
    /// Sets the unit of the open volume's values; HU at first.
    void setValues(const ValueUnit& values);
    /// Sets the histogram of the open volume and fits the visible range to it. Null: not known.
    void setHistogram(std::shared_ptr<const Histogram> histogram);
    /// Sets whether the next click on the image picks a tissue.
    void setPicking(bool picking);

    const TransferFunction& transferFunction() const { return function_; }
    CurveEditor& editor() { return editor_; }
    ColourStrip& strip() { return strip_; }

    QSize sizeHint() const override { return {316, 460}; }

  signals:
    /// Reports an edited transfer function. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void transferFunctionEdited(const pdr::TransferFunction& function, bool moving);
    void pickingChosen(bool picking);

  private:
    void layOut();
    void connectParts();
    void showFunction();
    void showCurve();
    void showPoint();
    void fit();
    void apply(const TransferFunction& function, bool moving);
    void editCurve(bool moving);
    void editColours(bool moving);
    void chooseShape(const CurveShape& shape);
    void chooseDensity(double extinctionPerMm);
    void typeHu(double hu);
    void typeValue(double value);
    void beginWith(PointsPlot& plot);
    TissueChannel channel() const { return TissueChannel(channel_.currentIndex()); }

    TransferFunction function_;
    TransferFunction base_;  ///< start of the edits of one curve, so that its own points stay its own
    std::shared_ptr<const Histogram> histogram_;
    QComboBox channel_;
    QCheckBox logarithmic_;
    ShapeRow shape_;
    CurveEditor editor_;
    ColourStrip strip_;
    PointRow point_;
    QDoubleSpinBox density_;
    QPushButton pick_;
    ValueUnit values_;
    PointsPlot* edited_ = &editor_;  ///< the plot whose points the row shows
};

}  // namespace pdr::ui
