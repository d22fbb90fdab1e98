#include "ui/measure/mark_painter.h"

#include <QCoreApplication>
#include <QLineF>
#include <algorithm>
#include <cmath>

#include "ui/text/language.h"
#include "ui/view/mark.h"
#include "ui/view/view_places.h"

namespace pdr::ui {
namespace {

constexpr double kHandle = 5;   ///< radius of a handle under the pointer [px]
constexpr double kFarMm = 20;   ///< measurements farther off a slice are not shown
constexpr double kLeader = 20;  ///< labels farther from their place have a line to it [px]

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(MarksLayer)
};

/// How a mark lies to the slice.
struct Off {
    double nearestMm = INFINITY;  ///< signed distance of the place that lies nearest
    bool inSlice = true;          ///< all places lie in it
};

Off offSlice(const ShownMark& mark, const ImagePlace& image) {
    Off off;
    for (const dvec3& place : mark.placesMm) {
        const double depth = depthMm(image, place);
        off.inSlice = off.inSlice && std::abs(depth) <= kInSliceMm;
        if (std::abs(depth) < std::abs(off.nearestMm))
            off.nearestMm = depth;
    }
    return off;
}

void drawLabel(QPainter& painter, const QRectF& place, const QString& text) {
    painter.setPen(Qt::black);
    for (const QPointF off : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)})
        painter.drawText(place.translated(off), Qt::AlignCenter, text);
    painter.setPen(QColor(kMarkColour));
    painter.drawText(place, Qt::AlignCenter, text);
}

/// Returns the point of `place` that lies nearest to `at`.
QPointF nearest(const QRectF& place, QPointF at) {
    return {std::clamp(at.x(), place.left(), place.right()), std::clamp(at.y(), place.top(), place.bottom())};
}

}  // namespace

MarkPainter::MarkPainter(QPainter& painter, const ImagePlace& image, bool slice)
    : painter_(painter), image_(image), slice_(slice) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

void MarkPainter::paint(const ShownMark& mark, int lit, const MarkHidden& hidden) {
    const bool ball = mark.shape == MarkShape::ball && mark.placesMm.size() == 2;
    const Off off = slice_ ? offSlice(mark, image_) : Off{0, true};
    const std::vector<MarkCurve> curves = curvesOf(mark, *image_.camera, slice_);
    if (ball ? curves.empty() : std::abs(off.nearestMm) > kFarMm)
        return;
    for (const dvec3& place : mark.placesMm)
        if (!seenAt(image_, place))
            return;
    const bool solid = off.inSlice || ball;
    const QPen pen(QColor(kMarkColour), mark.selected ? 2 : 1.3, solid ? Qt::SolidLine : Qt::DashLine);
    for (std::size_t i = 0; i < curves.size(); ++i)
        paintCurve(curves[i], pen, i < hidden.parts.size() ? hidden.parts[i] : std::vector<bool>());
    for (std::size_t i = 0; i < mark.placesMm.size(); ++i)
        if (!ball || !slice_ || std::abs(depthMm(image_, mark.placesMm[i])) <= kInSliceMm)
            paintHandle(mark.placesMm[i], lit == int(i), i < hidden.places.size() && hidden.places[i]);
    QString text = mark.text;
    if (!solid && std::abs(off.nearestMm) > kInSliceMm)
        text += "  " + Texts::tr("%1 mm off").arg(number(std::abs(off.nearestMm), 1));
    if (text.isEmpty())
        return;
    wishes_.push_back({*seenAt(image_, mark.placesMm.back()), painter_.fontMetrics().size(0, text)});
    labels_.push_back(text);
}

/// Paints a curve, dotted where it is hidden.
void MarkPainter::paintCurve(const MarkCurve& curve, const QPen& pen, const std::vector<bool>& hidden) {
    const auto isHidden = [&](std::size_t part) { return part < hidden.size() && hidden[part]; };
    QPen dotted = pen;
    dotted.setStyle(Qt::DotLine);
    dotted.setCapStyle(Qt::FlatCap);
    painter_.setBrush(Qt::NoBrush);
    QPolygonF run;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const auto at = seenAt(image_, curve[i]);
        if (!at)
            return;
        run << *at;
        const bool ends = i + 1 == curve.size() || (i > 0 && isHidden(i) != isHidden(i - 1));
        if (!ends || i == 0)
            continue;
        drawMarkLine(painter_, run, isHidden(i - 1) ? dotted : pen);
        run = QPolygonF({*at});
    }
}

void MarkPainter::paintHandle(const dvec3& placeMm, bool lit, bool hollow) {
    const double radius = lit ? kHandle : kHandle / 2;
    painter_.setPen(QPen(hollow ? QColor(kMarkColour) : QColor(Qt::black), 1));
    painter_.setBrush(hollow ? QBrush(Qt::NoBrush) : QBrush(QColor(kMarkColour)));
    painter_.drawEllipse(*seenAt(image_, placeMm), radius, radius);
}

void MarkPainter::paintLabels() {
    const std::vector<QRectF> places = labelPlaces(wishes_, QRectF(QPointF(), image_.view));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const QPointF at = wishes_[i].at, end = nearest(places[i], at);
        if (QLineF(at, end).length() > kLeader)
            drawMarkLine(painter_, at, end, QPen(QColor(kMarkColour), 0.8));
        drawLabel(painter_, places[i], labels_[i]);
    }
}

}  // namespace pdr::ui
