#include "app/presenters/clipboard_image.h"

#include "ui/annotation/image_painter.h"

namespace pdr::app {
namespace {

/// Returns an image that owns its pixels, 4 bytes each without gaps between the rows.
QImage ownImage(const std::vector<std::uint8_t>& rgba, ivec2 size) {
    return QImage(rgba.data(), size.x, size.y, 4 * qsizetype(size.x), QImage::Format_RGBX8888).copy();
}

std::vector<std::uint8_t> stretched(const Frame& frame, ivec2 size) {
    const QImage image = ownImage(frame.rgba, frame.size)
                             .scaled(size.x, size.y, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                             .convertToFormat(QImage::Format_RGBX8888);
    return {image.constBits(), image.constBits() + image.sizeInBytes()};
}

}  // namespace

QImage copyOf(const Frame& frame, ivec2 fullSize, const std::optional<ui::Annotations>& annotations) {
    const ivec2 size = frame.coarse ? fullSize : frame.size;
    std::vector<std::uint8_t> rgba = frame.coarse ? stretched(frame, size) : frame.rgba;
    if (const PaintOver paintOver = ui::imagePainter(annotations, frame.stop.levels)(shownOf(frame)))
        paintOver(size, rgba);
    return ownImage(rgba, size);
}

}  // namespace pdr::app
