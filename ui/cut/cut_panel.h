#pragma once
/// The panel with the exact numbers of all cuts: the sides of the box, the planes, and freehand lines. Setters emit no
/// signals.

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

    /// Sets the cuts. `uncut`: the box that can be cut; none: cutting is not possible.
    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);

    QSize sizeHint() const override { return {316, 380}; }

  signals:
    void clipChosen(const pdr::Clip& clip);
    /// Requests a plane perpendicular to an axis of the patient: 0 sagittal, 1 coronal, 2 axial; -1: facing the viewer.
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
