#pragma once
/// All keys and mouse gestures at a glance, over the whole window; any key or click takes it away.

#include <QAction>
#include <QList>
#include <QPointer>
#include <QWidget>

namespace pdr::ui {

class KeysOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit KeysOverlay(QWidget* window);

    /// Covers the window with the gestures and the keys that `actions` have now, or goes away.
    void toggle(const QList<QAction*>& actions);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    struct Line {
        QString keys, effect;
    };

    QList<Line> lines_;
    QPointer<QWidget> before_;  ///< had the keyboard
};

}  // namespace pdr::ui
