#pragma once
/// What floats over a picture and costs it no room: a frame that keeps its place while the picture's view changes its
/// size, and lets no mouse through to it.

#include <QFrame>

namespace pdr::ui {

class Floating : public QFrame {
  public:
    /// Over `picture`; none: it stays where it is put.
    explicit Floating(QWidget* picture);

  protected:
    /// Takes its place again: what is in it has changed.
    void place();
    /// Where it lies in a view of that size [px].
    virtual QRect placeIn(QSize view) = 0;

    bool event(QEvent* event) override;
    bool eventFilter(QObject* picture, QEvent* event) override;
};

}  // namespace pdr::ui
