#pragma once
/// The interface of a tool: what the pointer, the wheel and the keys do in a view, and what the view paints for it. A
/// tool knows no view, so that it works in any view that shows an image.

#include <QKeyEvent>
#include <QObject>
#include <QPainter>
#include <optional>

#include "ui/view/view_pointer.h"

namespace pdr::ui {

class ViewTool : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// Returns whether a press begins a gesture. The tool then has the pointer until all buttons are released.
    virtual bool takes(const ViewPointer&) const { return false; }
    virtual void press(const ViewPointer&) {}
    virtual void move(const ViewPointer&) {}
    virtual void release(const ViewPointer&) {}
    /// Handles a move without a gesture. Returns whether the pointer is on something of the tool's, which hides the
    /// tools behind it.
    virtual bool hover(const ViewPointer&) { return false; }
    /// Handles that the pointer left the view, or is on another tool.
    virtual void leave() {}
    /// Handles the wheel; `clicks` > 0: away from the user. Returns whether the tool uses it.
    virtual bool wheel(const ViewPointer&, [[maybe_unused]] double clicks) { return false; }
    /// Handles a key. Returns whether the tool uses it.
    virtual bool key(const QKeyEvent&) { return false; }
    /// Handles Esc: cancels what the tool is doing. Returns false if it does nothing.
    virtual bool cancel() { return false; }
    /// Handles that another tool has been activated.
    virtual void stepBack() {}

    /// Returns the cursor that the tool needs now; none: it leaves it to others.
    virtual std::optional<Qt::CursorShape> cursor() const { return std::nullopt; }
    /// Handles that the view shows another image or has another size.
    virtual void setImage(const ImagePlace&) {}
    virtual void paint(QPainter&, const ImagePlace&) const {}

  signals:
    /// Reports that what the tool paints, or its cursor, has changed.
    void changed();
    /// Requests to be in front of the view's other tools, which then step back.
    void activated();
};

}  // namespace pdr::ui
