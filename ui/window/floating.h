#pragma once
/// A frame that floats over the image and takes no layout space from it. It keeps its place when the view is resized,
/// and lets no mouse event through to the view.

#include <QFrame>

namespace pdr::ui {

class Floating : public QFrame {
  public:
    /// Creates a frame over the widget `image` and follows its size. Null: the frame stays where it is put.
    explicit Floating(QWidget* image);

  protected:
    /// Moves the frame to placeIn() again. Call it when the content has changed.
    void place();
    /// Returns the frame's rectangle in a view of size `view` [px].
    virtual QRect placeIn(QSize view) = 0;

    bool event(QEvent* event) override;
    bool eventFilter(QObject* image, QEvent* event) override;
};

}  // namespace pdr::ui
