#include "ui/annotation/orientation_cube.h"

#include <QPolygonF>
#include <QTransform>
#include <array>

namespace pdr::ui {
namespace {

/// A face of the cube: its letter, its normal, and the letter's upward direction (LPS).
struct Face {
    char letter;
    dvec3 normal;
    dvec3 up;
};

const std::array<Face, 6> kFaces{{{'L', {1, 0, 0}, {0, 0, 1}},
                                  {'R', {-1, 0, 0}, {0, 0, 1}},
                                  {'P', {0, 1, 0}, {0, 0, 1}},
                                  {'A', {0, -1, 0}, {0, 0, 1}},
                                  {'H', {0, 0, 1}, {0, -1, 0}},
                                  {'F', {0, 0, -1}, {0, -1, 0}}}};

QPointF onScreen(const Camera& camera, dvec3 direction) {
    return {glm::dot(direction, camera.right()), -glm::dot(direction, camera.imageUp())};
}

/// Returns the transform from the face's own coordinates (x right, y down, each in [-1, 1]) to the screen's.
QTransform faceToScreen(const Camera& camera, const Face& face) {
    const QPointF right = onScreen(camera, glm::cross(face.up, face.normal));
    const QPointF down = onScreen(camera, -face.up);
    const QPointF centre = onScreen(camera, face.normal);
    return {right.x(), right.y(), down.x(), down.y(), centre.x(), centre.y()};
}

void paintFace(QPainter& painter, const Camera& camera, const Face& face) {
    const double towardsViewer = -glm::dot(face.normal, camera.forward());
    if (towardsViewer <= 0)
        return;
    painter.save();
    painter.setTransform(faceToScreen(camera, face), true);
    const int grey = 40 + int(60 * towardsViewer);
    painter.setBrush(QColor(grey, grey, grey + 6, 220));
    QPen edge(QColor(150, 155, 160), 0);
    edge.setCosmetic(true);
    painter.setPen(edge);
    painter.drawRect(QRectF(-1, -1, 2, 2));
    // Lay the text out in a hundred units per face, because font sizes are whole numbers
    painter.scale(0.01, 0.01);
    QFont font = painter.font();
    font.setPixelSize(120);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(QColor(235, 235, 235, int(255 * std::min(1.0, 0.2 + towardsViewer))));
    painter.drawText(QRectF(-100, -100, 200, 200), Qt::AlignCenter, QString(QChar(face.letter)));
    painter.restore();
}

}  // namespace

void paintOrientationCube(QPainter& painter, const QRectF& area, const Camera& camera) {
    constexpr double kHalfDiagonal = 1.7321;  // half the diagonal of a cube that reaches from -1 to 1
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(area.center());
    const double scale = area.width() / (2 * kHalfDiagonal);
    painter.scale(scale, scale);
    for (const Face& face : kFaces)
        paintFace(painter, camera, face);
    painter.restore();
}

}  // namespace pdr::ui
