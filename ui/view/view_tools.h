#pragma once
/// The tools of one view: passes each event to the tool that it concerns. Tools are ordered from front to back; the
/// front one is asked first and painted last.

#include <vector>

#include "ui/view/view_tool.h"

namespace pdr::ui {

class ViewTools : public QObject {
    Q_OBJECT

  public:
    /// Adds a tool in front of the others. A tool that is destroyed is removed.
    void add(ViewTool& tool);
    /// Makes a press of `button` with `modifiers` held, and perhaps others, begin a gesture of `tool` if no tool takes
    /// the press by itself. Of several matches the one with most modifiers counts, then the one bound first. Adds the
    /// tool if necessary.
    void bind(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, ViewTool& tool);

    /// Returns whether a tool takes a press by itself, before any that is bound to the button.
    bool take(const ViewPointer& pointer) const;
    /// Returns whether a tool has the pointer.
    bool inGesture() const { return owner_; }
    void press(const ViewPointer& pointer);
    void move(const ViewPointer& pointer);
    /// Ends the gesture if no button is held any more.
    void release(const ViewPointer& pointer);
    /// Handles that the pointer has left the view.
    void leave();
    /// Passes on the wheel. Returns whether a tool uses it.
    bool wheel(const ViewPointer& pointer, double clicks);
    /// Passes on a key. Returns whether a tool uses it.
    bool key(const QKeyEvent& event);
    /// Cancels what the front tool that does anything is doing. Returns false if there is none.
    bool cancel();

    Qt::CursorShape cursor() const;
    /// Sets the image that the view shows, and the view's size.
    void setImage(const ImagePlace& image);
    void paint(QPainter& painter) const;

  signals:
    /// Reports that the view must be painted again, and that the cursor may have changed.
    void changed();

  private:
    struct Binding {
        Qt::MouseButton button;
        Qt::KeyboardModifiers modifiers;
        ViewTool* tool;
    };

    ViewTool* toolFor(const ViewPointer& pointer) const;
    void toFront(ViewTool& tool);
    void remove(const ViewTool* tool);
    void leaveAllBut(const ViewTool* kept);

    std::vector<ViewTool*> tools_;   ///< from front to back
    std::vector<Binding> bindings_;  ///< those with more modifiers first
    ViewTool* owner_ = nullptr;      ///< the tool that has the pointer
    ImagePlace image_;
};

}  // namespace pdr::ui
