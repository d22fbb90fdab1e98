#include "ui/measure/profile_chart.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/text/language.h"
#include "ui/text/value_text.h"

namespace pdr::ui {
namespace {

constexpr int kTicks = 4;        ///< about as many are on an axis
constexpr double kTickPx = 3;    ///< their length
constexpr double kLevelPx = 14;  ///< half of the length of the line at a half level
constexpr double kLeastHu = 20;  ///< least range of the axis: noise of a few HU is not shown as large as an edge

/// Returns a round step, 1, 2 or 5 times a power of ten, of which about kTicks make up `range`.
double stepOf(double range) {
    const double rough = range / kTicks, power = std::pow(10.0, std::floor(std::log10(rough)));
    const double lead = rough / power;
    return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

/// Calls visit(value) for the round values from `low` to `high`.
template <class Visit>
void eachTick(double low, double high, Visit&& visit) {
    const double step = stepOf(high - low);
    for (double n = std::ceil(low / step); n * step <= high; ++n)
        visit(n * step + 0.0);  // no "-0"
}

}  // namespace

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Values along the distance"));
    setToolTip(
        tr("The values along the chosen distance, and beyond it. Dashed: its ends; dots: the half levels at which "
           "they lie. The pointer and the arrow keys read off values."));
    hide();
}

void ProfileChart::setProfile(const std::optional<ShownProfile>& profile) {
    setVisible(profile.has_value());
    if (!profile || *profile == profile_)
        return;
    profile_ = *profile;
    const auto& samples = profile_.samples;
    mm_ = {samples.front().mm, std::max(samples.back().mm, samples.front().mm + 1)};
    const auto [low, high] = std::ranges::minmax_element(samples, {}, &ShownProfile::Sample::hu);
    const double middle = (low->hu + high->hu) / 2, least = kLeastHu * profile_.unit.step;
    const double half = std::max(0.55 * (high->hu - low->hu), least / 2);
    hu_ = {middle - half, middle + half};
    read_ = -1;
    describe();
    update();
}

/// Says to a screen reader what the chart shows, and what is read off.
void ProfileChart::describe() {
    const auto [low, high] = std::ranges::minmax_element(profile_.samples, {}, &ShownProfile::Sample::hu);
    QString text =
        tr("From %1 to %2 %3 over %4 mm.").arg(value(low->hu), value(high->hu), unit(), number(profile_.lengthMm, 1));
    for (const std::optional<double>& level : profile_.halfLevels)
        if (level)
            text += ' ' + tr("An end at an edge, at %1 %2.").arg(value(*level), unit());
    if (read_ >= 0)
        text = reading() + ". " + text;
    setAccessibleDescription(text);
}

QString ProfileChart::reading() const {
    if (read_ < 0)
        return {};
    const ShownProfile::Sample& sample = profile_.samples[std::size_t(read_)];
    if (!sample.measured)
        return tr("%1 mm: nothing measured").arg(number(sample.mm, 1));
    return (sample.acrossHole ? tr("%1 mm: %2 %3, interpolated across a hole") : tr("%1 mm: %2 %3"))
        .arg(number(sample.mm, 1), value(sample.hu), unit());
}

/// Returns a value with as many decimals as tell neighbouring voxels apart.
QString ProfileChart::value(double each) const {
    return number(each, profile_.unit.decimals());
}

QString ProfileChart::unit() const {
    return unitName(profile_.unit);
}

void ProfileChart::read(int index) {
    read_ = std::clamp(index, 0, int(profile_.samples.size()) - 1);
    describe();
    update();
}

void ProfileChart::keyPressEvent(QKeyEvent* event) {
    const int last = int(profile_.samples.size()) - 1;
    switch (event->key()) {
        case Qt::Key_Left:
            return read(read_ - 1);
        case Qt::Key_Right:
            return read(read_ + 1);
        case Qt::Key_Home:
            return read(0);
        case Qt::Key_End:
            return read(last);
        default:
            QWidget::keyPressEvent(event);
    }
}

void ProfileChart::mouseMoveEvent(QMouseEvent* event) {
    const double share = (event->position().x() - ground().left()) / ground().width();
    read(int(std::lround(share * double(profile_.samples.size() - 1))));
}

/// Returns where the curve is painted: what the numbers of the axes leave.
QRectF ProfileChart::ground() const {
    const QFontMetricsF font(this->font());
    double widest = 0;
    eachTick(hu_.low, hu_.high, [&](double hu) { widest = std::max(widest, font.horizontalAdvance(value(hu))); });
    return QRectF(rect()).adjusted(widest + kTickPx + 4, font.height() + 2, -6, -font.height() - kTickPx - 2);
}

QPointF ProfileChart::pointOf(double mm, double hu) const {
    const QRectF at = ground();
    return {at.left() + at.width() * (mm - mm_.low) / (mm_.high - mm_.low),
            at.bottom() - at.height() * (hu - hu_.low) / (hu_.high - hu_.low)};
}

void ProfileChart::paintEvent(QPaintEvent*) {
    if (profile_.samples.size() < 2)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxes(painter);
    paintEnds(painter);
    paintCurve(painter);
    paintReading(painter);
}

void ProfileChart::paintAxes(QPainter& painter) const {
    const QRectF at = ground();
    const double line = QFontMetricsF(font()).height();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawLine(at.bottomLeft(), at.bottomRight());
    painter.drawLine(at.bottomLeft(), at.topLeft());
    eachTick(hu_.low, hu_.high, [&](double hu) {
        const double y = pointOf(mm_.low, hu).y();
        painter.drawLine(QPointF(at.left() - kTickPx, y), QPointF(at.left(), y));
        painter.drawText(QRectF(0, y - line / 2, at.left() - kTickPx - 2, line), Qt::AlignRight | Qt::AlignVCenter,
                         value(hu));
    });
    const QString mmUnit = tr("mm");
    const double room = QFontMetricsF(font()).horizontalAdvance(mmUnit) + 4;
    painter.drawText(QRectF(at.right() - room, at.bottom() + kTickPx, room, line), Qt::AlignRight, mmUnit);
    eachTick(mm_.low, mm_.high, [&](double mm) {
        const double x = pointOf(mm, hu_.low).x(), half = QFontMetricsF(font()).horizontalAdvance(number(mm, 0)) / 2;
        painter.drawLine(QPointF(x, at.bottom()), QPointF(x, at.bottom() + kTickPx));
        if (x + half < at.right() - room)  // else it would touch the unit
            painter.drawText(QRectF(x - 2 * half - 4, at.bottom() + kTickPx, 4 * half + 8, line), Qt::AlignHCenter,
                             number(mm, mm_.high - mm_.low < kTicks ? 1 : 0));
    });
    painter.drawText(QRectF(0, 0, at.left() + 40, line), Qt::AlignLeft, unit());
}

/// Paints a dashed line at either end of the distance, and a dot on the half level of an edge there.
void ProfileChart::paintEnds(QPainter& painter) const {
    const QColor accent = palette().color(QPalette::Highlight);
    const double ends[]{0, profile_.lengthMm};
    for (std::size_t n = 0; n < 2; ++n) {
        painter.setPen(QPen(accent, 1, Qt::DashLine));
        painter.drawLine(pointOf(ends[n], hu_.low), pointOf(ends[n], hu_.high));
        if (!profile_.halfLevels[n])
            continue;
        const QPointF level = pointOf(ends[n], *profile_.halfLevels[n]);
        painter.setPen(QPen(accent, 1));
        painter.drawLine(level - QPointF(kLevelPx, 0), level + QPointF(kLevelPx, 0));
        painter.setBrush(accent);
        painter.drawEllipse(level, 3, 3);
    }
}

/// Paints the curve, which is interrupted where nothing was measured, and dotted across a hole.
void ProfileChart::paintCurve(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    const auto& samples = profile_.samples;
    QPolygonF run;
    bool dotted = false;
    const auto paintRun = [&] {
        painter.setPen(
            QPen(palette().color(QPalette::WindowText), 1.5, dotted ? Qt::DotLine : Qt::SolidLine, Qt::FlatCap));
        painter.drawPolyline(std::exchange(run, {}));
    };
    for (std::size_t n = 1; n < samples.size(); ++n) {
        const ShownProfile::Sample &from = samples[n - 1], &to = samples[n];
        const bool acrossHole = from.acrossHole || to.acrossHole;
        if (!from.measured || acrossHole != dotted)
            paintRun();
        dotted = acrossHole;
        if (from.measured && to.measured)
            run << (run.isEmpty() ? QPolygonF{pointOf(from.mm, from.hu)} : QPolygonF()) << pointOf(to.mm, to.hu);
    }
    paintRun();
}

void ProfileChart::paintReading(QPainter& painter) const {
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    if (read_ < 0)
        return;
    const ShownProfile::Sample& sample = profile_.samples[std::size_t(read_)];
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(rect()).adjusted(4, 1, -6, 0), Qt::AlignRight | Qt::AlignTop, reading());
    if (sample.measured)
        painter.drawEllipse(pointOf(sample.mm, sample.hu), 3.5, 3.5);
}

}  // namespace pdr::ui
