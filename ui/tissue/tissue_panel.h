#pragma once
/// The tissue's optics over Hounsfield units, to see and to edit: a curve at a time over this patient's histogram, the
/// colours below it, and the exact numbers. Setters are silent.

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

    /// Another than the hand has made ends what it does, and shows as free points.
    void setTransferFunction(const TransferFunction& function);
    /// Of the volume that is shown, all of which is then seen; null: none is known.
    void setHistogram(std::shared_ptr<const Histogram> histogram);
    /// Whether the next click on the picture picks a tissue.
    void setPicking(bool picking);

    const TransferFunction& transferFunction() const { return function_; }
    CurveEditor& editor() { return editor_; }
    ColourStrip& strip() { return strip_; }

    QSize sizeHint() const override { return {316, 460}; }

  signals:
    /// `moving`: the gesture goes on; the last edit of a gesture comes with false.
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
    TransferFunction base_;  ///< what the edits of one curve start from, so that its own points stay its own
    std::shared_ptr<const Histogram> histogram_;
    QComboBox channel_;
    QCheckBox logarithmic_;
    ShapeRow shape_;
    CurveEditor editor_;
    ColourStrip strip_;
    PointRow point_;
    QDoubleSpinBox density_;
    QPushButton pick_;
    PointsPlot* edited_ = &editor_;  ///< the plot whose points the row shows
};

}  // namespace pdr::ui
