#include "ui/cut/cut_marks.h"

#include <QLineF>
#include <algorithm>

#include "ui/view/mark.h"

namespace pdr::ui {
namespace {

using Kind = CutHandle::Kind;

constexpr double kDot = 6;        ///< radius of a handle [px]
constexpr double kDotReach = 11;  ///< distance from which the pointer reaches a handle [px]
constexpr double kLineReach = 5;
constexpr QRgb kPlaneColour = qRgb(130, 200, 255);

QColor colourOf(CutHandle handle) {
    return QColor(handle.kind == Kind::face || handle.kind == Kind::box ? kMarkColour : kPlaneColour);
}

double distanceTo(const QLineF& line, QPointF place) {
    const QPointF along = line.p2() - line.p1(), away = place - line.p1();
    const double squared = QPointF::dotProduct(along, along);
    const double part = squared > 0 ? std::clamp(QPointF::dotProduct(away, along) / squared, 0.0, 1.0) : 0;
    return QLineF(line.pointAt(part), place).length();
}

double distanceTo(const QPolygonF& points, QPointF place) {
    double nearest = 1e30;
    for (qsizetype i = 0; i + 1 < points.size(); ++i)
        nearest = std::min(nearest, distanceTo(QLineF(points[i], points[i + 1]), place));
    return nearest;
}

/// Paints a line that is visible on dark ground and on bright bone.
void paintLine(QPainter& painter, const QPolygonF& points, QColor colour, double width) {
    painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2));
    painter.drawPolyline(points);
    painter.setPen(QPen(colour, width));
    painter.drawPolyline(points);
}

}  // namespace

CutMarks::CutMarks(const Clip& clip, const Uncut& uncut, const ViewGeometry& view, const QRectF& area)
    : view_(view), area_(area) {
    addBox(clip, uncut);
    for (int i = 0; i < int(clip.planes.size()); ++i)
        addPlane(clip.planes[std::size_t(i)], i, uncut);
}

void CutMarks::addBox(const Clip& clip, const Uncut& uncut) {
    const ClipBox box = cropBox(clip, uncut);
    const auto corner = [&](int i) { return glm::mix(box.lowMm, box.highMm, dvec3(i & 1, (i >> 1) & 1, i >> 2)); };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit))
                addLine({Kind::box, 0}, {corner(i), corner(i | bit)}, clip.box.has_value());
    for (int face = 0; face < 6; ++face)
        addDot({Kind::face, face}, faceMiddle(box, face), outwardsOf(face));
}

void CutMarks::addPlane(const ClipPlane& plane, int number, const Uncut& uncut) {
    std::vector<dvec3> outline = planeOutline(plane, uncut);
    if (!outline.empty())
        outline.push_back(outline.front());
    addLine({Kind::offset, number}, outline, false);
    addLine({Kind::tilt, number}, tiltRing(plane, uncut), true);
    addDot({Kind::offset, number}, planeMiddle(plane, uncut));
}

void CutMarks::addDot(CutHandle handle, dvec3 placeMm, dvec3 outwards) {
    if (const std::optional<dvec2> point = view_->at(placeMm))
        dots_.push_back({handle, inPixels(*point), glm::dot(outwards, view_->under(*point).direction) > 0});
}

/// Adds a line piece by piece, since parts may lie behind the eye.
void CutMarks::addLine(CutHandle handle, const std::vector<dvec3>& placesMm, bool holds) {
    Line line{handle, {}, holds};
    for (std::size_t i = 0; i + 1 < placesMm.size(); ++i) {
        const auto piece = view_->lineAt(placesMm[i], placesMm[i + 1]);
        if (piece && line.points.isEmpty())
            line.points << inPixels(piece->first);
        if (piece)
            line.points << inPixels(piece->second);
    }
    if (!line.points.isEmpty())
        lines_.push_back(std::move(line));
}

QPointF CutMarks::inPixels(dvec2 point) const {
    return area_.topLeft() + QPointF(point.x * area_.width(), point.y * area_.height());
}

std::optional<QPointF> CutMarks::placeOf(CutHandle handle) const {
    for (const Dot& dot : dots_)
        if (dot.handle == handle)
            return dot.place;
    for (const Line& line : lines_)
        if (line.handle == handle)
            return line.points.first();
    return std::nullopt;
}

std::optional<CutHandle> CutMarks::at(QPointF place) const {
    std::optional<CutHandle> found;
    double nearest = kDotReach;
    for (const bool behind : {false, true})
        for (const Dot& dot : dots_)
            if (const double away = QLineF(dot.place, place).length();
                dot.behind == behind && away < nearest && (!behind || !found)) {
                nearest = away;
                found = dot.handle;
            }
    if (found)
        return found;
    nearest = kLineReach;
    for (const Line& line : lines_)
        if (const double away = distanceTo(line.points, place); line.holds && away < nearest) {
            nearest = away;
            found = line.handle;
        }
    return found;
}

void CutMarks::paint(QPainter& painter, const std::optional<CutHandle>& lit) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const Line& line : lines_) {
        QColor colour = colourOf(line.handle);
        colour.setAlpha(line.holds ? 255 : 130);
        paintLine(painter, line.points, colour, line.holds && lit == line.handle ? 2.5 : 1);
    }
    for (const Dot& dot : dots_) {
        const bool isLit = lit == dot.handle;
        const QColor colour = isLit ? QColor(Qt::white) : colourOf(dot.handle);
        const double radius = isLit ? kDot + 2 : dot.behind ? kDot - 2 : kDot;
        painter.setPen(QPen(dot.behind ? colour : QColor(0, 0, 0, 190), 1.5));
        painter.setBrush(dot.behind ? QColor(0, 0, 0, 110) : colour);
        painter.drawEllipse(dot.place, radius, radius);
    }
}

}  // namespace pdr::ui
