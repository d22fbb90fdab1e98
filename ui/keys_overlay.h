#pragma once
/// All keys and mouse gestures at a glance, over the whole window; any key or click takes it away.

#include <QWidget>

namespace pdr::ui {

class KeysOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit KeysOverlay(QWidget* window);

    /// Covers the window, or goes away.
    void toggle();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace pdr::ui
