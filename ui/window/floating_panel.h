#pragma once
/// A panel that floats over the lower part of the image, with a heading and a button that closes it.

#include <QAction>

#include "ui/window/floating.h"

namespace pdr::ui {

class FloatingPanel : public Floating {
    Q_OBJECT

  public:
    /// Creates the panel, hidden at first. Where there is room, it leaves the orientation letters, the cube and the
    /// texts in the image's corners uncovered.
    FloatingPanel(QWidget* image, const QString& title, QWidget* panel, const QKeySequence& key);

    /// Returns the action that shows and hides the panel.
    QAction* toggleViewAction() { return &toggle_; }

  protected:
    QRect placeIn(QSize view) override;

  private:
    QAction toggle_;
};

}  // namespace pdr::ui
