#pragma once
/// The tool with which the user draws a closed line on the image and chooses what it cuts. It takes the mouse only
/// while it is drawing. Setters emit no signals that edit.

#include <QPolygonF>
#include <QPushButton>
#include <optional>

#include "render/scene/clip.h"
#include "ui/view/drawing_tool.h"

namespace pdr::ui {

class FreehandPen : public DrawingTool {
    Q_OBJECT

  public:
    /// Creates the pen and its buttons, which lie in the widget `view`.
    FreehandPen(QWidget* view, QObject* parent);

    void press(const ViewPointer& pointer) override;
    void move(const ViewPointer& pointer) override;
    void release(const ViewPointer& pointer) override;
    /// Sets the image. Another camera discards the line.
    void setImage(const ImagePlace& image) override;
    void paint(QPainter& painter, const ImagePlace& image) const override;

  signals:
    void drawn(const pdr::FreehandCut& cut);
    /// Reports the end of drawing: a line was completed, was none (a click, or a line around nothing), or was canceled.
    void ended();

  private:
    void discard() override;
    void reportNothing() override { emit ended(); }
    void discardLine();
    void ask(QPoint place);
    void answer(bool keepInside);
    std::vector<ImagePoint> outline() const;

    ImagePlace image_;
    bool pressed_ = false;
    QPolygonF line_;               ///< [px]
    QWidget* answers_;             ///< shown where the mouse was released
    QPushButton *remove_, *keep_;  ///< on answers_
};

}  // namespace pdr::ui
