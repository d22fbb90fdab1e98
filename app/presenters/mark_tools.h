#pragma once
/// The tools that measure: an action for each kind of measurement, in the menu and on the panel.

#include <QAction>
#include <QMenu>
#include <array>
#include <optional>

#include "app/plan/measurement.h"
#include "ui/measure/marks_panel.h"

namespace pdr::app {

class MarkTools : public QObject {
    Q_OBJECT

  public:
    /// Adds the actions to `menu`, `panel` and `window`, whose keys they are.
    MarkTools(QMenu& menu, ui::MarksPanel& panel, QWidget& window);

    void setEnabled(bool enabled);
    /// Sets which tool is on; none: none is.
    void setDrawing(const std::optional<MeasureKind>& kind);

  signals:
    /// Reports that the user begins to measure; none: gives up.
    void chosen(std::optional<pdr::app::MeasureKind> kind);

  private:
    std::array<QAction*, kMeasureKinds> actions_{};  ///< in the order of MeasureKind
};

}  // namespace pdr::app
