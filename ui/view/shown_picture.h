#pragma once
/// The picture in its view: how it lies there, and what is written and drawn over it.

#include <QImage>
#include <QLineF>
#include <QList>
#include <QPainter>
#include <QStringList>

#include "render/scene/camera.h"

namespace pdr::ui {

/// A picture and what it shows.
struct ShownPicture {
    QImage image;   ///< of whatever size: it is stretched to the view's height
    Camera camera;  ///< that it was made with; letters and cube are painted from it
    QString texts;  ///< what it shows, in lines; written into a corner, ...
    QString mark;   ///< ... with what else must be known of the picture; empty: nothing
    QList<QLineF>
        lostLines;    ///< that are missing in the image [its pixels]: brackets stand at their ends, with the map
    QString caption;  ///< below the mark, where nothing beside the picture says it: PictureView::caption
    QImage errorMap;  ///< painted over the image, with a legend; null: none
    bool beforeDenoising = false;  ///< the map is of what the image was then
};

/// Where it is painted.
struct PictureView {
    QSize size;              ///< [px]
    double pixelRatio = 1;   ///< of the screen's own pixels
    bool captioned = false;  ///< whether its caption is written, too
    QStringList overlay;     ///< lines in the upper left corner
};

/// The part of the view that the picture takes, in its middle [px]. The field of view belongs to the height, so the
/// picture is fitted to it: what is seen is what a picture of the view's own size would show, at the same place. Where
/// the heights are all but the same, it is shown pixel by pixel.
QRectF pictureArea(const QSize& image, const PictureView& view);
/// The picture, with the map, letters, cube, brackets and texts over it. What it leaves free stays as it was.
void paintShownPicture(QPainter& painter, const ShownPicture& picture, const PictureView& view);

}  // namespace pdr::ui
