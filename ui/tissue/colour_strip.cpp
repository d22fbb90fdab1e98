#include "ui/tissue/colour_strip.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/tissue/curve_painter.h"
#include "ui/tissue/place_step.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::ui {
namespace {

constexpr double kHandle = 6;  ///< half the width of a stop's handle, and its height above the edge [px]

Curve placesOf(const std::vector<ColourStop>& stops) {
    Curve places;
    for (const ColourStop& stop : stops)
        places.push_back({stop.hu, 0});
    return places;
}

}  // namespace

ColourStrip::ColourStrip(QWidget* parent) : PointsPlot(CurveHand::Kind::level, parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Colours over Hounsfield units"));
    connect(this, &PointsPlot::edited, this, &ColourStrip::describe);
    connect(this, &PointsPlot::selectionChanged, this, &ColourStrip::describe);
    setStops(stops_);
}

void ColourStrip::setStops(const std::vector<ColourStop>& stops) {
    stops_ = stops;
    setPoints(placesOf(stops), 0);
    describe();
}

void ColourStrip::setColour(std::size_t stop, const QColor& colour, bool moving) {
    if (stop >= stops_.size())
        return;
    stops_[stop].albedo = linearColour(colour);
    update();
    emit edited(moving);
}

void ColourStrip::setMargins(int left, int right) {
    left_ = left;
    right_ = right;
    layOut();
}

void ColourStrip::setValues(const ValueUnit& values) {
    values_ = values;
    setAccessibleName(values.isHu ? tr("Colours over Hounsfield units") : tr("Colours over the values of the scan"));
    describe();
}

QString ColourStrip::placeText(double voxel) const {
    return ui::placeText(view(), values_, voxel);
}

void ColourStrip::layOut() {
    setArea(QRectF(left_, 3, width() - left_ - right_, height() - 2 * kHandle - 4));
}

void ColourStrip::resizeEvent(QResizeEvent*) {
    layOut();
}

void ColourStrip::describe() {
    QStringList lines{tr("%n stop(s)", nullptr, int(stops_.size()))};
    for (const std::size_t i : selection())
        if (i < stops_.size())
            lines << tr("selected, %1: %2").arg(placeText(stops_[i].hu), screenColour(stops_[i].albedo).name());
    setAccessibleDescription(lines.join("; "));
}

CurvePoint ColourStrip::step() const {
    return {float(std::max(view().rounded(view().huPerPixel()), view().placeStep())), 0};
}

QString ColourStrip::tipAt(QPointF place) const {
    const double hu = view().hu(place.x());
    return tr("%1: %2\nDrag stops; Ctrl and click adds one; double click chooses a colour")
        .arg(placeText(view().rounded(hu)), screenColour(albedoAt(stops_, hu)).name());
}

/// Adds a stop in the colour that the strip has there.
void ColourStrip::pointAdded(std::size_t index) {
    const float hu = points()[index].hu;
    stops_.insert(stops_.begin() + std::ptrdiff_t(index), {hu, albedoAt(stops_, double(hu))});
}

void ColourStrip::pointsRemoved(const CurveSelection& removed) {
    std::vector<ColourStop> rest;
    for (std::size_t i = 0; i < stops_.size(); ++i)
        if (!std::binary_search(removed.begin(), removed.end(), i))
            rest.push_back(stops_[i]);
    stops_ = rest.empty() ? std::vector{stops_.front()} : rest;
}

void ColourStrip::pointsMoved() {
    for (std::size_t i = 0; i < stops_.size(); ++i)
        stops_[i].hu = points()[i].hu;
}

void ColourStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF& area = view().area();
    painter.fillRect(area, gradientOf(stops_, view()));
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        const double x = view().x(double(stops_[i].hu));
        if (x < area.left() - 1 || x > area.right() + 1)
            continue;
        const bool selected = std::binary_search(selection().begin(), selection().end(), i);
        const QPolygonF handle{QPointF(x, area.bottom() - kHandle), QPointF(x + kHandle, area.bottom() + 2),
                               QPointF(x + kHandle, area.bottom() + 2 + kHandle),
                               QPointF(x - kHandle, area.bottom() + 2 + kHandle),
                               QPointF(x - kHandle, area.bottom() + 2)};
        painter.setPen(QPen(palette().color(selected ? QPalette::Link : QPalette::WindowText), selected ? 2.5 : 1.2));
        painter.setBrush(screenColour(stops_[i].albedo));
        painter.drawPolygon(handle);
    }
    paintFocus(painter);
}

void ColourStrip::askForColour(std::size_t stop) {
    const QColor before = screenColour(stops_[stop].albedo);
    auto* dialog = new QColorDialog(before, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour at %1").arg(placeText(stops_[stop].hu)));
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [this, stop](const QColor& colour) { setColour(stop, colour, true); });
    connect(dialog, &QDialog::finished, this, [this, stop, dialog, before](int result) {
        setColour(stop, result == QDialog::Accepted ? dialog->currentColor() : before, false);
    });
    dialog->open();
}

void ColourStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto stop = hand().pointAt(view(), event->position()))
        askForColour(*stop);
    else
        PointsPlot::mouseDoubleClickEvent(event);
}

void ColourStrip::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && !hand().isHolding() && !selection().empty())
        askForColour(selection().front());
    else
        PointsPlot::keyPressEvent(event);
}

}  // namespace pdr::ui
