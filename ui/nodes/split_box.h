#pragma once
/// How the work is shared out among nodes: as its costs say, or as the user wants it. Setters are silent.

#include <QComboBox>
#include <optional>

#include "render/base/split.h"

namespace pdr::ui {

class SplitBox : public QComboBox {
    Q_OBJECT

  public:
    explicit SplitBox(QWidget* parent = nullptr);

    /// None: as its costs say.
    void setSplit(std::optional<Split> split);

  signals:
    /// By hand.
    void splitRequested(const std::optional<pdr::Split>& split);
};

}  // namespace pdr::ui
