#include "ui/view/shown_image.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/annotation/annotations.h"
#include "ui/view/error_legend.h"
#include "ui/view/upsampled.h"

namespace pdr::ui {
namespace {

constexpr int kMargin = 12;
/// colour of brackets, which the user cannot move and which measure nothing
constexpr QRgb kLostColour = qRgb(110, 185, 190);

/// Returns the size of the view in screen pixels.
QSize sizeInPixels(const ImageView& view) {
    return (QSizeF(view.size) * view.pixelRatio).toSize();
}

/// Returns whether the image is shown pixel by pixel. A tolerance of 2 % keeps a panel that takes a few rows from
/// blurring the image.
bool isPixelByPixel(const QSize& image, const ImageView& view) {
    constexpr double kSame = 0.02;
    const int height = sizeInPixels(view).height();
    return std::abs(image.height() - height) <= kSame * height;
}

/// Returns the upper left corner of an image centred in the view, which it may exceed [screen pixels].
QPoint cornerInPixels(const QSize& image, const ImageView& view) {
    const QSize beside = sizeInPixels(view) - image;
    return {beside.width() / 2, beside.height() / 2};
}

/// Enlarges an image that is shown at twice its height or more without visible pixel blocks. While the view moves,
/// images have few pixels. The result is limited to a million pixels, since more would delay the interaction.
QImage withoutBlocks(const QImage& image, QSizeF shown) {
    constexpr double kMostPixels = 1e6;
    if (image.depth() != 32 || shown.height() < 2 * image.height())
        return image;
    const double scale = std::min(1.0, std::sqrt(kMostPixels / (shown.width() * shown.height())));
    return upsampled(image, (shown * scale).toSize().expandedTo(image.size()));
}

/// Returns a bracket at each end of the line, open towards the other.
QPainterPath bracketsAround(const QLineF& line) {
    constexpr double kBeyond = 4, kHalf = 6, kHook = 4;
    QPainterPath path;
    for (const QLineF& from : {line, QLineF(line.p2(), line.p1())}) {
        const QPointF along = (from.p2() - from.p1()) / std::max(from.length(), 1.0), across(-along.y(), along.x());
        const QPointF corner = from.p1() - kBeyond * along;
        path.moveTo(corner - kHalf * across + kHook * along);
        path.lineTo(corner - kHalf * across);
        path.lineTo(corner + kHalf * across);
        path.lineTo(corner + kHalf * across + kHook * along);
    }
    return path;
}

/// The state of painting one image.
struct Painting {
    QPainter& painter;
    const ShownImage& picture;
    const ImageView& view;
    QFont plain;

    QRect withinMargins() const { return QRect({}, view.size).adjusted(kMargin, kMargin, -kMargin, -kMargin); }
    QRectF area() const { return imageArea(picture.image.size(), view); }

    void paintImage(const QImage& image) const;
    void paintErrorMap() const;
    void paintLostLines() const;
    void paintTexts() const;
};

void Painting::paintImage(const QImage& image) const {
    if (isPixelByPixel(image.size(), view)) {
        // paint in screen pixels, of which a px need not be a multiple
        painter.scale(1 / view.pixelRatio, 1 / view.pixelRatio);
        painter.drawImage(cornerInPixels(image.size(), view), image);
        return painter.resetTransform();
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area(), withoutBlocks(image, area().size() * view.pixelRatio));
}

void Painting::paintErrorMap() const {
    if (picture.errorMap.isNull())
        return;
    paintImage(picture.errorMap);
    QRect legend = withinMargins();
    if (!view.overlay.isEmpty())  // the patient's lines stand above it
        legend.adjust(0, int(view.overlay.size()) * QFontMetrics(plain).lineSpacing() + kMargin, 0, 0);
    paintErrorLegend(painter, legend, picture.beforeDenoising);
}

/// Paints brackets at the ends of lost lines, only with the error map: without it they would be taken for findings. The
/// line itself stays free, so that it is visible if the film is shown instead of the denoised image.
void Painting::paintLostLines() const {
    if (picture.errorMap.isNull())
        return;
    const double scale = area().height() / picture.image.height();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QLineF& line : picture.lostLines) {
        const QLineF shown(area().topLeft() + scale * line.p1(), area().topLeft() + scale * line.p2());
        const QPainterPath brackets = bracketsAround(shown);
        painter.strokePath(brackets.translated(1, 1), QPen(QColor(0, 0, 0, 150), 1));
        painter.strokePath(brackets, QPen(QColor(kLostColour), 1, Qt::DotLine));
    }
    painter.restore();
}

/// Paints the annotations, also where the image fills the screen.
void Painting::paintTexts() const {
    painter.setFont(plain);
    paintAnnotations(
        painter,
        {picture.camera, view.overlay, {picture.texts, picture.mark, view.captioned ? picture.caption : QString()}},
        view.size);
}

}  // namespace

QRectF imageArea(const QSize& image, const ImageView& view) {
    if (isPixelByPixel(image, view))
        return {QPointF(cornerInPixels(image, view)) / view.pixelRatio, QSizeF(image) / view.pixelRatio};
    const double scale = double(view.size.height()) / image.height();
    QRectF area(0, 0, image.width() * scale, view.size.height());
    area.moveCenter(QRectF({}, QSizeF(view.size)).center());
    const bool onlyRounded = std::abs(area.width() - view.size.width()) <= 2 * scale;  // size rounded to pixels
    return onlyRounded ? QRectF({}, QSizeF(view.size)) : area;
}

void paintShownImage(QPainter& painter, const ShownImage& picture, const ImageView& view) {
    const Painting painting{painter, picture, view, painter.font()};
    painting.paintImage(picture.image);
    painting.paintErrorMap();
    painting.paintLostLines();
    painting.paintTexts();
}

}  // namespace pdr::ui
