#include "app/caption.h"

#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <algorithm>

#include "ui/accuracy_text.h"

namespace pdr::app {
namespace {

constexpr int kSmallest = 9;  ///< pixels: what can just be read

QFont fontFor(const QString& text, ivec2 size) {
    QFont font;
    int height = std::max(size.y / 45, 12);
    do
        font.setPixelSize(height);
    while (--height >= kSmallest && QFontMetrics(font).horizontalAdvance(text) + font.pixelSize() > size.x);
    return font;
}

}  // namespace

Caption captionOf(const QString& text, ivec2 size) {
    if (text.isEmpty())
        return {};
    const QFont font = fontFor(text, size);
    const QFontMetrics metrics(font);
    const int margin = font.pixelSize() / 2;
    QImage image(metrics.horizontalAdvance(text) + 2 * margin, metrics.height() + margin, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(image.rect(), Qt::AlignCenter, text);
    painter.end();
    Caption caption{{image.width(), image.height()}, {}};
    for (int y = 0; y < image.height(); ++y)
        caption.coverage.insert(caption.coverage.end(), image.constScanLine(y), image.constScanLine(y) + image.width());
    return caption;
}

QString captionOn(const Frame& frame, bool captioned) {
    return captioned ? ui::previewText(frame.status, frame.stop.levels, frame.smoothed) : QString();
}

}  // namespace pdr::app
