#include "ui/light/light_sphere.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/screen_colour.h"

namespace pdr::ui {
namespace {

constexpr double kBall = 0.68;   ///< radius of the ball, relative to the ring's
constexpr double kHandle = 6.5;  ///< radius of a handle [px]
constexpr double kReach = 11;    ///< distance from which the pointer reaches a handle [px]
constexpr double kKeyStep = 5;   ///< step of the arrow keys [degrees]

}  // namespace

LightSphere::LightSphere(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::TabFocus);
    setAccessibleName(tr("Places of the lamps"));
    setAccessibleDescription(
        tr("Arrow keys move the chosen lamp, Page up and Page down choose another, Shift and arrow keys turn all."));
    setToolTip(
        tr("Drag a lamp to where the light is to come from: over the ball it stands on your side, in the ring about it "
           "behind the patient. Beside the lamps, a drag turns them all. On the image, Shift and the right button do "
           "the same."));
}

void LightSphere::setLamps(const std::vector<SphereLamp>& lamps) {
    lamps_ = lamps;
    current_ = std::clamp(current_, 0, std::max(int(lamps_.size()) - 1, 0));
    ball_ = {};
    update();
}

void LightSphere::setCurrent(int index) {
    current_ = std::clamp(index, 0, std::max(int(lamps_.size()) - 1, 0));
    update();
}

void LightSphere::letGo() {
    held_ = turning_ = false;
}

double LightSphere::ringRadius() const {
    return std::max(std::min(width(), height()) / 2.0 - kHandle - 1, 1.0);
}

double LightSphere::ballRadius() const {
    return kBall * ringRadius();
}

QPointF LightSphere::middle() const {
    return QRectF(rect()).center();
}

/// Projects the lamp orthographically onto the ball; in the ring, the farther out it is, the more it shines from
/// behind.
QPointF LightSphere::handleOf(dvec3 from) const {
    const dvec2 across(from.x, from.y);
    const double sine = glm::length(across), behind = std::atan2(-from.z, sine) / (M_PI / 2);
    const double radius = from.z >= 0 ? ballRadius() * sine : glm::mix(ballRadius(), ringRadius(), behind);
    const dvec2 way = sine > 1e-9 ? across / sine : dvec2(0, 1);
    return middle() + QPointF(way.x, -way.y) * radius;
}

dvec3 LightSphere::directionAt(QPointF place) const {
    const QPointF offset = place - middle();
    const double radius = std::hypot(offset.x(), offset.y());
    if (radius <= ballRadius()) {
        const dvec2 across = dvec2(offset.x(), -offset.y()) / ballRadius();
        return {across, std::sqrt(std::max(1 - glm::dot(across, across), 0.0))};
    }
    const double behind = std::min((radius - ballRadius()) / (ringRadius() - ballRadius()), 1.0) * M_PI / 2;
    return {dvec2(offset.x(), -offset.y()) / radius * std::cos(behind), -std::sin(behind)};
}

/// Returns the nearest lamp within reach; the current one if several are as near. -1: none.
int LightSphere::lampAt(QPointF place) const {
    int found = -1;
    double nearest = kReach;
    for (int i = 0; i < int(lamps_.size()); ++i) {
        const double distance = QLineF(handleOf(lamps_[std::size_t(i)].from), place).length();
        if (distance < nearest || (distance == nearest && i == current_)) {
            nearest = distance;
            found = i;
        }
    }
    return found;
}

void LightSphere::choose(int index) {
    if (index == current_ || lamps_.empty())
        return;
    setCurrent(index);
    emit currentChanged(current_);
}

void LightSphere::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || lamps_.empty())
        return;
    last_ = event->position();
    const int lamp = lampAt(last_);
    held_ = lamp >= 0;
    turning_ = !held_;
    if (held_)
        choose(lamp);
}

void LightSphere::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - last_;
    if ((!held_ && !turning_) || moved.isNull())
        return;
    last_ = event->position();
    if (held_)
        emit lampMoved(current_, directionAt(last_), true);
    else
        emit allTurned(dvec2(moved.x(), moved.y()) / (2 * ballRadius()), true);
}

void LightSphere::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (std::exchange(held_, false))
        emit lampMoved(current_, lamp().from, false);
    if (std::exchange(turning_, false))
        emit allTurned({0, 0}, false);
}

/// Turns the current lamp to the right about the vertical, and up.
void LightSphere::moveBy(dvec2 degrees) {
    const dvec3 from = lamp().from;
    const double azimuth = std::atan2(from.x, from.z) + glm::radians(degrees.x);
    const double highest = M_PI / 2 - 1e-3;
    const double elevation =
        std::clamp(std::asin(std::clamp(from.y, -1.0, 1.0)) + glm::radians(degrees.y), -highest, highest);
    const dvec2 level(std::sin(azimuth), std::cos(azimuth));
    emit lampMoved(current_, {level.x * std::cos(elevation), std::sin(elevation), level.y * std::cos(elevation)},
                   false);
}

void LightSphere::keyPressEvent(QKeyEvent* event) {
    const int count = int(lamps_.size());
    dvec2 way(0);
    switch (event->key()) {
        case Qt::Key_Left:
            way.x = -1;
            break;
        case Qt::Key_Right:
            way.x = 1;
            break;
        case Qt::Key_Up:
            way.y = 1;
            break;
        case Qt::Key_Down:
            way.y = -1;
            break;
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            return choose(count ? (current_ + (event->key() == Qt::Key_PageUp ? count - 1 : 1)) % count : 0);
        default:
            return QWidget::keyPressEvent(event);
    }
    if (lamps_.empty())
        return;
    if (event->modifiers().testFlag(Qt::ShiftModifier))
        emit allTurned(dvec2(way.x, -way.y) * (kKeyStep / 180), false);
    else
        moveBy(kKeyStep * way);
}

void LightSphere::resizeEvent(QResizeEvent*) {
    ball_ = {};
}

void LightSphere::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double ratio = devicePixelRatioF();
    if (ball_.isNull())
        ball_ = litBall(lamps_, std::max(int(std::ceil(2 * ballRadius() * ratio)), 1));
    // Paint the ring
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(middle(), ringRadius(), ringRadius());
    // Paint the ball
    const QRectF area(middle() - QPointF(ballRadius(), ballRadius()), 2 * QSizeF(ballRadius(), ballRadius()));
    QBrush lit(ball_);
    QTransform place = QTransform::fromTranslate(area.x(), area.y());
    place.scale(area.width() / ball_.width(), area.height() / ball_.height());
    lit.setTransform(place);
    painter.setBrush(lit);
    painter.drawEllipse(area);
    // Paint the handles, the current one last
    for (int i = 0; i < int(lamps_.size()); ++i)
        if (i != current_)
            paintHandle(painter, i);
    if (!lamps_.empty())
        paintHandle(painter, current_);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Link), 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

/// Paints a handle, light with a dark edge, so that it stands out on any background.
void LightSphere::paintHandle(QPainter& painter, int index) const {
    const SphereLamp& lamp = lamps_[std::size_t(index)];
    const QPointF place = handleOf(lamp.from);
    const bool chosen = index == current_;
    const float brightest = std::max({lamp.colour.x, lamp.colour.y, lamp.colour.z, 1e-6f});
    painter.setPen(QPen(Qt::black, chosen ? 4.5 : 3));
    painter.setBrush(screenColour(glm::mix(vec3(1), lamp.colour / brightest, 0.5f)));
    painter.drawEllipse(place, kHandle - 1, kHandle - 1);
    painter.setPen(QPen(chosen ? palette().color(QPalette::Link) : QColor(Qt::white), chosen ? 2.5 : 1));
    if (lamp.irradiance <= 0)
        painter.setBrush(palette().color(QPalette::Base));  // the lamp is off
    painter.drawEllipse(place, kHandle - 1, kHandle - 1);
}

}  // namespace pdr::ui
