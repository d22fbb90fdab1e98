#pragma once
/// The image in its view: where it lies, and what is painted over it.

#include <QImage>
#include <QLineF>
#include <QList>
#include <QPainter>
#include <QStringList>

#include "render/scene/camera.h"

namespace pdr::ui {

/// An image and its annotations.
struct ShownImage {
    QImage image;                  ///< any size: it is stretched to the height of the view
    Camera camera;                 ///< camera of the image; letters and cube are painted from it
    QString texts;                 ///< description of the image in lines, written into a corner
    QString mark;                  ///< written below `texts`: what else must be known of the image; empty: nothing
    QList<QLineF> lostLines;       ///< missing in the image [its pixels]; with the map, brackets mark their ends
    QString caption;               ///< written below `mark` if ImageView::captioned
    QImage errorMap;               ///< painted over the image, with a legend; null: none
    bool beforeDenoising = false;  ///< the map shows the error before denoising
};

/// The view in which the image is painted.
struct ImageView {
    QSize size;              ///< [px]
    double pixelRatio = 1;   ///< screen pixels per px
    bool captioned = false;  ///< whether the caption is painted as well
    QStringList overlay;     ///< lines in the upper left corner
};

/// Returns the part of the view that the image takes, centred [px]. The field of view belongs to the height, so the
/// image is fitted to the height: each point appears where an image of the view's own size would show it. If the
/// heights differ by at most 2 %, the image is shown pixel by pixel.
QRectF imageArea(const QSize& image, const ImageView& view);
/// Paints the image with error map, letters, cube, brackets and texts over it. Areas outside the image are not painted.
void paintShownImage(QPainter& painter, const ShownImage& picture, const ImageView& view);

}  // namespace pdr::ui
