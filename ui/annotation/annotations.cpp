#include "ui/annotation/annotations.h"

#include <QCoreApplication>
#include <QFontInfo>
#include <QImage>
#include <QPainterPath>
#include <algorithm>

#include "ui/annotation/orientation_cube.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/annotation/scale_bar.h"

namespace pdr::ui {
namespace {

const QColor kInk(235, 235, 225);
const QColor kGround(0, 0, 0, 150);  ///< behind texts, which may lie on bright bone

/// The state of painting the annotations once. Lengths are in `em`, the height of the font [px].
struct Painting {
    QPainter& painter;
    const Annotations& annotations;
    QSize size;
    QFont plain = painter.font();
    double em = QFontInfo(plain).pixelSize();

    QRectF withinMargins() const { return QRectF({}, QSizeF(size)).adjusted(0.9 * em, 0.9 * em, -0.9 * em, -0.9 * em); }
    QRectF cube() const;

    void paintLetters() const;
    void paintLetter(Qt::Alignment where, const std::string& text) const;
    void paintScaleBar() const;
    QRectF roomForLines(Qt::Alignment where) const;
    void paintLines(Qt::Alignment where, const QStringList& lines) const;
};

QRectF Painting::cube() const {
    QRectF area(0, 0, 5 * em, 5 * em);
    area.moveBottomRight(withinMargins().bottomRight());
    return area;
}

/// Paints the letter with a dark rim, so that it is legible on bright tissue without hiding it.
void Painting::paintLetter(Qt::Alignment where, const std::string& text) const {
    QFont font = plain;
    font.setPixelSize(int(std::lround(1.3 * em)));
    font.setBold(true);
    QPainterPath path;
    path.addText(0, 0, font, QString::fromStdString(text));
    const QRectF is = path.boundingRect(), within = withinMargins();
    QRectF wanted(QPointF(), is.size());
    wanted.moveCenter(within.center());
    if (where & Qt::AlignLeft)
        wanted.moveLeft(within.left());
    if (where & Qt::AlignRight)
        wanted.moveRight(within.right());
    if (where & Qt::AlignTop)
        wanted.moveTop(within.top());
    if (where & Qt::AlignBottom)
        wanted.moveBottom(within.bottom());
    path.translate(wanted.topLeft() - is.topLeft());
    painter.strokePath(path, QPen(QColor(0, 0, 0, 200), 0.25 * em, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, kInk);
}

void Painting::paintLetters() const {
    const EdgeLetters edges = edgeLetters(annotations.camera);
    paintLetter(Qt::AlignLeft, edges.left);
    paintLetter(Qt::AlignRight, edges.right);
    paintLetter(Qt::AlignTop, edges.top);
    paintLetter(Qt::AlignBottom, edges.bottom);
}

/// Paints the scale bar above the cube, or in its place, and its length above the bar.
void Painting::paintScaleBar() const {
    const auto bar = scaleBar(annotations.camera, size.height(), std::min(0.25 * size.width(), 12 * em));
    if (!bar || bar->pixels < em)
        return;
    const QPointF corner = annotations.cube ? cube().topRight() : withinMargins().bottomRight();
    const QPointF right = corner - QPointF(0, 0.6 * em), left = right - QPointF(bar->pixels, 0);
    const QPointF tick(0, 0.3 * em);
    QPainterPath path(left - tick);
    path.lineTo(left + tick);
    path.moveTo(left);
    path.lineTo(right);
    path.moveTo(right - tick);
    path.lineTo(right + tick);
    painter.strokePath(path, QPen(QColor(0, 0, 0, 200), 0.3 * em));
    painter.strokePath(path, QPen(kInk, 0.12 * em));
    QRectF words = QFontMetricsF(plain).boundingRect(bar->text).adjusted(-0.3 * em, 0, 0.3 * em, 0);
    words.moveBottomRight(right - QPointF(0, 0.6 * em));
    painter.fillRect(words, kGround);
    painter.setPen(kInk);
    painter.drawText(words, Qt::AlignCenter, bar->text);
}

/// Returns the room for lines in a corner: beside the letter in the middle of the edge or, in a slice so narrow that
/// lines would be wrapped there, before the letter's row, as far as the scale bar's words may reach.
QRectF Painting::roomForLines(Qt::Alignment where) const {
    const QRectF all = withinMargins();
    QRectF room = all;
    room.setWidth(all.width() / 2 - 2.5 * em);
    if (annotations.cube || room.width() >= 14 * em)
        return room;
    room.setWidth(std::max(room.width(), all.width() - 6 * em));
    const double letter = 1.7 * em;
    return where & Qt::AlignTop ? room.adjusted(0, letter, 0, 0) : room.adjusted(0, 0, 0, -letter);
}

/// Paints lines into a corner; long lines are wrapped.
void Painting::paintLines(Qt::Alignment where, const QStringList& lines) const {
    if (lines.isEmpty())
        return;
    const QRectF room = roomForLines(where);
    const int flags = int(where) | Qt::TextWordWrap;
    const QString text = lines.join('\n');
    const QRectF words = painter.boundingRect(room, flags, text);
    painter.fillRect(words.adjusted(-0.4 * em, -0.2 * em, 0.4 * em, 0.2 * em), kGround);
    painter.setPen(kInk);
    painter.drawText(room, flags, text);
}

bool hasLines(const QSize& size, double em, int lines) {
    return std::min(size.width(), size.height()) >= lines * em;
}

}  // namespace

void paintAnnotations(QPainter& painter, const Annotations& annotations, const QSize& size) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const Painting painting{painter, annotations, size};
    if (hasLines(size, painting.em, 4))
        painting.paintLetters();
    if (hasLines(size, painting.em, 12)) {
        if (annotations.cube)
            paintOrientationCube(painter, painting.cube(), annotations.camera);
        painting.paintScaleBar();
        painting.paintLines(Qt::AlignLeft | Qt::AlignTop, annotations.patient);
        QStringList texts = annotations.texts;
        texts << QCoreApplication::translate("Annotations", "Not for diagnostic use");
        texts.removeAll({});
        painting.paintLines(Qt::AlignLeft | Qt::AlignBottom, texts);
    }
    painter.restore();
}

void annotate(const Annotations& annotations, ivec2 size, std::vector<std::uint8_t>& rgba) {
    constexpr int kSmallest = 9;  // smallest legible font size [px]
    QImage image(rgba.data(), size.x, size.y, 4 * qsizetype(size.x), QImage::Format_RGBX8888);
    QPainter painter(&image);
    QFont font;
    font.setPixelSize(std::max(std::min(size.x, size.y) / 50, kSmallest));
    painter.setFont(font);
    paintAnnotations(painter, annotations, {size.x, size.y});
}

}  // namespace pdr::ui
