#pragma once
/// The row of one plane of the cut: its orientation, its distance in millimetres, and buttons. Setters emit no signals.

#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

class PlaneRow : public QWidget {
    Q_OBJECT

  public:
    explicit PlaneRow(QWidget* parent = nullptr);

    void setPlane(const ClipPlane& plane, const Uncut& uncut);

  signals:
    /// Reports a typed distance from the middle of the box that can be cut, along the plane's normal [mm].
    void offsetTyped(double mm);
    /// Requests to cut away the other side.
    void flipWanted();
    void removeWanted();

  private:
    QLabel name_;
    QDoubleSpinBox offset_;
    QToolButton flip_, remove_;
};

}  // namespace pdr::ui
