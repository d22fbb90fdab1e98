#pragma once
/// An overlay over the whole window that shows all keys and mouse gestures. Any key or click closes it.

#include <QAction>
#include <QList>
#include <QPointer>
#include <QWidget>

namespace pdr::ui {

class KeysOverlay : public QWidget {
    Q_OBJECT

  public:
    explicit KeysOverlay(QWidget* window);

    /// Shows the gestures and the current keys of `actions` over the window, or hides the overlay.
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
    QPointer<QWidget> before_;  ///< widget that had the focus before
};

}  // namespace pdr::ui
