#pragma once
/// The tool that shows measurements in a view, sets their places, and moves them. In a slice, a measurement that lies
/// off the slice is dashed, with the distance of its nearest end; beyond 20 mm it is not shown. In the image all are
/// shown, dotted where they are hidden. What is seen can be dragged: in a slice, the places that lie in it; in the
/// image, those that nothing hides, but for the figures that lie in a slice. Setters emit no signals.

#include <map>
#include <optional>
#include <vector>

#include "ui/measure/mark_handle.h"
#include "ui/measure/mark_painter.h"
#include "ui/view/view_tool.h"

namespace pdr::ui {

class MarksLayer : public ViewTool {
    Q_OBJECT

  public:
    /// `slice`: the layer is one of a slice. Else it is the image's, where it takes a look-up to know a place.
    explicit MarksLayer(bool slice) : slice_(slice) {}

    void setMarks(std::vector<ShownMark> marks);
    const std::vector<ShownMark>& marks() const { return marks_; }
    /// Sets whether something is being drawn, until Esc ends it. In a slice, presses of the left button set its places;
    /// in the image, clicks leave that to others, so that drags still turn it, and a flat figure has none.
    void setDrawing(bool drawing);
    /// Sets the places of what is being drawn; in a slice, the pointer is the next one.
    void setDrawn(MarkShape shape, std::vector<dvec3> placesMm);
    /// Sets whether what is being drawn lies in the slices of another view, where the pointer then shows no next place.
    void setElsewhere(bool elsewhere);
    /// Sets whether what is being drawn can be closed, by a click on its first place or a double click, and whether by
    /// Enter as well.
    void setClosing(bool closable, bool byEnter);
    /// Sets what of the marks is hidden, by their ids; others are shown as if nothing of them were.
    void setHidden(std::map<std::uint64_t, MarkHidden> hidden);
    const std::map<std::uint64_t, MarkHidden>& hidden() const { return hidden_; }
    /// Shows the place that was dropped where it was before, since the image shows no place there.
    void putBack();

    bool takes(const ViewPointer& pointer) const override;
    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;
    bool hover(const ViewPointer& pointer) override;
    void leave() override;
    bool key(const QKeyEvent& event) override;
    bool cancel() override;
    std::optional<Qt::CursorShape> cursor() const override;
    void paint(QPainter& painter, const ImagePlace& image) const override;

  signals:
    /// Reports a place that was set. `free`: not to be moved to an edge.
    void placed(pdr::dvec3 placeMm, bool free);
    /// Reports that place `index` of a measurement is dragged in a slice. `moving`: the button is held.
    void dragged(std::uint64_t id, int index, pdr::dvec3 placeMm, bool free, bool moving);
    /// Reports that place `index` of a measurement was dropped on the image: at `at`, in fractions of its width and
    /// height. It is shown there until the marks are set, or it is put back.
    void dropped(std::uint64_t id, int index, QPointF at);
    /// Requests to restore the measurements from before the drag; in the image, not to move the place that was dropped.
    void dragCancelled();
    void selected(std::uint64_t id);
    /// Requests to take back the last place that was set.
    void takenBack();
    /// Requests to close what is being drawn.
    void closed();
    /// Reports that Esc has ended drawing.
    void drawingCancelled();

  private:
    std::optional<MarkHandle> handleAt(const ViewPointer& pointer) const;
    bool closes(const ViewPointer& pointer) const;
    void drag(const ViewPointer& pointer, bool moving);
    void showNext(const ViewPointer& pointer);
    void paintDrawn(QPainter& painter, const ImagePlace& image) const;
    void light(const std::optional<MarkHandle>& handle);

    bool slice_;
    bool drawing_ = false, elsewhere_ = false, closable_ = false, closableByEnter_ = false;
    std::vector<ShownMark> marks_;
    std::map<std::uint64_t, MarkHidden> hidden_;
    ShownMark drawn_;                    ///< what is being drawn
    std::optional<dvec3> pointer_;       ///< place under the pointer while drawing
    std::optional<MarkHandle> lit_;      ///< under the pointer
    std::optional<MarkHandle> dragged_;  ///< pressed
    QPointF pressed_;                    ///< where it was pressed [px]
    bool dragging_ = false;              ///< the pointer has moved further than a tremble
    std::optional<MarkHandle> loose_;    ///< in the image, dragged or dropped and not yet set
    QPointF looseAt_;                    ///< where it is shown [px]
};

}  // namespace pdr::ui
