#pragma once
/// A panel over the lower part of a picture, with a heading and a way to fold it away.

#include <QAction>

#include "ui/window/floating.h"

namespace pdr::ui {

class FloatingPanel : public Floating {
    Q_OBJECT

  public:
    /// Folded away. The letters, the cube and the texts in the picture's corners stay free where there is room for it.
    FloatingPanel(QWidget* picture, const QString& title, QWidget* panel, const QKeySequence& key);

    /// That shows it and folds it away.
    QAction* toggleViewAction() { return &toggle_; }

  protected:
    QRect placeIn(QSize view) override;

  private:
    QAction toggle_;
};

}  // namespace pdr::ui
