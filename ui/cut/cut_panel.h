#pragma once
/// All that is cut away, in exact numbers: the box' sides, the planes, lines drawn by hand. Setters are silent.

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <optional>
#include <vector>

#include "ui/cut/plane_row.h"

namespace pdr::ui {

class CutPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CutPanel(QWidget* parent = nullptr);

    /// `uncut`: what there is to cut; none: nothing can be.
    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);

    QSize sizeHint() const override { return {316, 380}; }

  signals:
    void clipChosen(const pdr::Clip& clip);
    /// Across an axis of the patient: 0 sagittal, 1 coronal, 2 axial; -1: facing the viewer.
    void planeWanted(int axis);
    void freehandWanted();

  private:
    QLayout* boxRows();
    QLayout* planeButtons();
    void showPlanes();
    void typeSide(int face, double mm);
    void changePlane(std::size_t number, const ClipPlane& plane);
    void removePlane(std::size_t number);
    void removeLine();
    void choose(const Clip& clip);

    Clip clip_;
    Uncut uncut_;
    std::array<QDoubleSpinBox, 6> sides_;
    QVBoxLayout* planeColumn_;
    std::vector<PlaneRow*> planes_;
    std::vector<QPushButton*> addPlane_;
    QPushButton freehand_;
    QLabel lines_;
    QToolButton removeLine_;
    QCheckBox shadows_;
    QPushButton undoAll_;
};

}  // namespace pdr::ui
