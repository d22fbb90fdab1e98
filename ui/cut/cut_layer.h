#pragma once
/// The tool that shows the box and planes of the cut, with handles for the mouse. Presses beside a handle reach the
/// tools behind it. Setters emit no signals that edit.

#include <optional>

#include "ui/cut/cut_marks.h"
#include "ui/view/view_tool.h"

namespace pdr::ui {

class CutLayer : public ViewTool {
    Q_OBJECT

  public:
    using ViewTool::ViewTool;

    /// Sets the cuts. `uncut`: the box that can be cut; none: nothing is shown. Cuts that differ from the user's last
    /// edit end the gesture.
    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);
    void setHandlesShown(bool shown);
    bool handlesShown() const { return shown_; }
    const CutMarks& marks() const { return marks_; }

    /// Returns whether a press is on a handle: of the left button without modifiers, or the second of a double click.
    bool takes(const ViewPointer& pointer) const override;
    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;
    bool hover(const ViewPointer& pointer) override;
    void leave() override { light(std::nullopt); }
    bool cancel() override;
    std::optional<Qt::CursorShape> cursor() const override;
    void setImage(const ImagePlace& image) override;
    void paint(QPainter& painter, const ImagePlace& image) const override;

  signals:
    /// Reports edited cuts. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void clipEdited(const pdr::Clip& clip, bool moving);
    /// Requests to restore the cut from before the gesture.
    void gestureGivenUp();

  private:
    void bringBack(CutHandle handle);
    void edit(const Clip& clip, bool moving);
    void light(const std::optional<CutHandle>& handle);
    void mark();

    Clip clip_;
    std::optional<Uncut> uncut_;
    ImagePlace image_;
    CutMarks marks_;
    bool shown_ = false;
    std::optional<CutHandle> lit_;  ///< handle under the pointer
    std::optional<CutGrip> grip_;   ///< grip on the handle being dragged
    bool moved_ = false;            ///< the gesture has edited the cut
};

}  // namespace pdr::ui
