#pragma once
/// A table that shows and edits all panels of a rig in numbers. Setters emit no signals.

#include <QPushButton>
#include <QTableWidget>
#include <vector>

#include "render/scene/light_rig.h"

namespace pdr::ui {

class PanelTable : public QWidget {
    Q_OBJECT

  public:
    enum Column { name, azimuth, elevation, distance, edge, radiance, colour, kColumns };

    explicit PanelTable(QWidget* parent = nullptr);

    void setPanels(const std::vector<RigPanel>& panels);
    QTableWidget& cells() { return cells_; }

  signals:
    /// Reports edited panels. Typed values are in their range; others are rejected.
    void panelsEdited(const std::vector<pdr::RigPanel>& panels);

  private:
    void fill();
    void takeTyped(int row, int column);
    void askForColour(int row);
    void add();
    void remove();

    std::vector<RigPanel> panels_;
    QTableWidget cells_;
    QPushButton add_;
    QPushButton remove_;
};

}  // namespace pdr::ui
