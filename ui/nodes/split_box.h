#pragma once
/// The choice of how the work is divided among nodes: by its costs, or as the user chooses. Setters emit no signals.

#include <QComboBox>
#include <optional>

#include "render/base/split.h"

namespace pdr::ui {

class SplitBox : public QComboBox {
    Q_OBJECT

  public:
    explicit SplitBox(QWidget* parent = nullptr);

    /// Sets the split. None: chosen by cost.
    void setSplit(std::optional<Split> split);

  signals:
    /// Reports the user's choice. None: chosen by cost.
    void splitRequested(const std::optional<pdr::Split>& split);
};

}  // namespace pdr::ui
