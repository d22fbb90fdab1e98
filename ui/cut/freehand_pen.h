#pragma once
/// A closed line drawn on the picture, and the question what it is to cut: a layer over the picture that takes the
/// mouse as long as it is asked for. Setters are silent.

#include <QPolygonF>
#include <QPushButton>
#include <optional>

#include "render/scene/clip.h"
#include "ui/view/picture_layer.h"

namespace pdr::ui {

class FreehandPen : public PictureLayer {
    Q_OBJECT

  public:
    explicit FreehandPen(QWidget* picture);

    /// The camera of the picture on the screen, and the picture's size [pixels]. Another view forgets a line.
    void setPicture(const Camera& camera, QSize size);
    /// The next drag draws a line; until it is answered what it cuts, the mouse does nothing else.
    void startDrawing() { takeMouse(); }
    void stopDrawing();
    bool isDrawing() const { return takesMouse(); }

  signals:
    void drawn(const pdr::FreehandCut& cut);
    /// It draws no more: a line was answered, or was none, by a click or around nothing.
    void ended();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void ask(QPoint place);
    void answer(bool keepInside);
    std::vector<PicturePoint> outline() const;

    std::optional<Camera> camera_;
    QSize size_;
    bool pressed_ = false;
    QPolygonF line_;   ///< [px]
    QWidget answers_;  ///< at the place where the mouse was released
    QPushButton remove_, keep_;
};

}  // namespace pdr::ui
