#pragma once
/// One plane of the cut: how it lies, where it is to the millimetre, and what can be done with it. Setters are silent.

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
    /// Its distance from the middle of what there is to cut, along its normal [mm].
    void offsetTyped(double mm);
    /// The other side is to be cut away.
    void flipWanted();
    void removeWanted();

  private:
    QLabel name_;
    QDoubleSpinBox offset_;
    QToolButton flip_, remove_;
};

}  // namespace pdr::ui
