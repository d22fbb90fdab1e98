#include "ui/tissue/tissue_panel.h"
#include "ui/widgets/screen_colour.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace pdr::ui {
namespace {

constexpr double kDensest = 1e6;  ///< largest extinction in a scene [1/mm]
constexpr double kRare = 0.0005;  ///< fraction of the voxels that may be outside the visible range at either end
constexpr double kAround = 0.04;  ///< margin at either end, as a fraction of the range

/// Returns the value at the end of the axis.
float topOf(const Curve& curve, TissueChannel channel) {
    if (channel != TissueChannel::emission)
        return highestValue(channel);
    return std::max(1.0f, 1.5f * heightOf(curve));
}

}  // namespace

TissuePanel::TissuePanel(QWidget* parent) : QWidget(parent) {
    function_.nodes = base_.nodes = {{}};
    channel_.addItems({tr("Opacity"), tr("Reflection"), tr("Roughness"), tr("Glow")});
    channel_.setAccessibleName(tr("Curve"));
    channel_.setToolTip(
        tr("Opacity: how much light is taken from a ray, per mm\nReflection: of a surface, seen straight "
           "on\nRoughness: 0 is a mirror, 1 is dull\nGlow: light that the tissue gives off itself"));
    logarithmic_.setText(tr("Log"));
    logarithmic_.setChecked(true);
    logarithmic_.setAccessibleName(tr("Logarithmic histogram"));
    logarithmic_.setToolTip(tr("The histogram's height grows with the logarithm of the voxels"));
    // Set up the density and the picking button
    density_.setRange(0, kDensest);
    density_.setDecimals(3);
    density_.setSingleStep(0.1);
    density_.setMinimumWidth(80);
    density_.setSuffix(tr(" /mm"));
    density_.setKeyboardTracking(false);
    density_.setAccessibleName(tr("Density at the top of the opacity curve"));
    density_.setToolTip(tr("Extinction at the top of the opacity curve: larger is denser tissue everywhere"));
    pick_.setText(tr("Thi&s tissue..."));
    pick_.setCheckable(true);
    pick_.setAccessibleName(tr("Show the tissue that is clicked"));
    pick_.setToolTip(tr("Then click the anatomy: a bell at its value is added (Ctrl and click does the same)"));
    for (QComboBox* box : {&channel_, &shape_.kinds()}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(7);
    }
    for (QWidget* control : std::initializer_list<QWidget*>{&channel_, &logarithmic_, &pick_})
        control->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    // Lay out, connect and fill
    layOut();
    connectParts();
    showFunction();
    fit();
}

void TissuePanel::layOut() {
    auto* densityLabel = new QLabel(tr("&Density"));
    densityLabel->setBuddy(&density_);
    auto* first = new QHBoxLayout;
    first->addWidget(&channel_, 1);
    first->addWidget(&shape_.kinds(), 1);
    first->addWidget(&logarithmic_);
    auto* last = new QHBoxLayout;
    last->addWidget(densityLabel);
    last->addWidget(&density_, 1);
    last->addWidget(&pick_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 4, 10, 8);
    column->setSpacing(5);
    column->addLayout(first);
    column->addWidget(&shape_);
    column->addWidget(&editor_, 1);
    column->addWidget(&strip_);
    column->addWidget(&point_);
    column->addLayout(last);
}

void TissuePanel::connectParts() {
    connect(&channel_, &QComboBox::currentIndexChanged, this, [this] {
        base_ = function_;
        shape_.setFree();
        showCurve();
    });
    connect(&logarithmic_, &QCheckBox::toggled, this,
            [this](bool on) { editor_.setBarScale(on ? BarScale::logarithmic : BarScale::linear); });
    connect(&shape_, &ShapeRow::shapeChosen, this, &TissuePanel::chooseShape);
    connect(&density_, &QDoubleSpinBox::valueChanged, this, &TissuePanel::chooseDensity);
    connect(&pick_, &QPushButton::clicked, this, &TissuePanel::pickingChosen);

    connect(&editor_, &PointsPlot::edited, this, &TissuePanel::editCurve);
    connect(&strip_, &PointsPlot::edited, this, &TissuePanel::editColours);
    for (PointsPlot* plot : std::initializer_list<PointsPlot*>{&editor_, &strip_}) {
        connect(plot, &PointsPlot::selectionChanged, this, [this, plot] { beginWith(*plot); });
        connect(plot, &PointsPlot::fitRequested, this, &TissuePanel::fit);
        connect(plot, &PointsPlot::rangeChanged, &editor_, &PointsPlot::setRange);
        connect(plot, &PointsPlot::rangeChanged, &strip_, &PointsPlot::setRange);
    }
    connect(&point_, &PointRow::huTyped, this, &TissuePanel::typeHu);
    connect(&point_, &PointRow::valueTyped, this, &TissuePanel::typeValue);
    connect(&point_, &PointRow::removeWanted, this, [this] { edited_->removeSelected(); });
    connect(&point_, &PointRow::colourWanted, this, [this] { strip_.askForColour(strip_.selection().front()); });
}

void TissuePanel::setTransferFunction(const TransferFunction& function) {
    if (function == function_ || function.nodes.empty())
        return;
    function_ = base_ = function;
    shape_.setFree();
    showFunction();
}

void TissuePanel::setValues(const ValueUnit& values) {
    values_ = values;
    editor_.setValues(values);
    strip_.setValues(values);
    point_.setValues(values);
    shape_.setValues(values);
    showCurve();
}

void TissuePanel::setHistogram(std::shared_ptr<const Histogram> histogram) {
    histogram_ = std::move(histogram);
    editor_.setHistogram(histogram_);
    shape_.setBasis(editor_.points(), histogram_);
    fit();
}

void TissuePanel::setPicking(bool picking) {
    pick_.setChecked(picking);
}

void TissuePanel::showFunction() {
    strip_.setStops(coloursOf(function_));
    const QSignalBlocker silent(&density_);
    density_.setValue(double(function_.extinctionPerMm));
    showCurve();
}

void TissuePanel::showCurve() {
    const Curve curve = curveOf(function_, channel());
    const bool opacity = channel() == TissueChannel::opacity;
    const QString over = values_.isHu ? tr("%1 over Hounsfield units") : tr("%1 over the values of the scan");
    editor_.setAccessibleName(over.arg(channel_.currentText()));
    editor_.setColours(strip_.stops());
    editor_.setCurve(curve, topOf(curve, channel()), opacity ? double(function_.extinctionPerMm) : 1,
                     opacity ? tr("/mm") : QString());
    strip_.setMargins(editor_.plotMargins().left(), editor_.plotMargins().right());
    shape_.setBasis(editor_.points(), histogram_);
    showPoint();
}

/// Shows the first selected point in the row.
void TissuePanel::showPoint() {
    const CurveSelection& selection = edited_->selection();
    const bool any = !selection.empty() && selection.front() < edited_->points().size();
    if (edited_ == &strip_ && any) {
        const ColourStop& stop = strip_.stops()[selection.front()];
        return point_.setStop(stop.hu, screenColour(stop.albedo));
    }
    const bool opacity = channel() == TissueChannel::opacity;
    const double highest = opacity ? kDensest : double(highestValue(channel()));
    const auto point = any ? std::optional(edited_->points()[selection.front()]) : std::nullopt;
    point_.setPoint(point, editor_.unit(), highest, opacity ? tr("/mm") : QString());
}

void TissuePanel::beginWith(PointsPlot& plot) {
    if (edited_ != &plot) {
        edited_->clearSelection();
        edited_ = &plot;
        base_ = function_;
    }
    showPoint();
}

/// Makes the range visible that contains nearly all voxels, and all points.
void TissuePanel::fit() {
    const Curve& points = editor_.points();
    double low = double(points.front().hu), high = double(points.back().hu);
    if (histogram_ && histogram_->total() > 0) {
        low = std::min(low, histogram_->percentile(kRare));
        high = std::max(high, histogram_->percentile(1 - kRare));
    }
    const double room = kAround * (high - low) + 1;
    point_.setSpan(high - low + 2 * room);
    shape_.setSpan(high - low + 2 * room);
    editor_.setRange(low - room, high + room);
    strip_.setRange(low - room, high + room);
}

/// Applies an edit and reports it. An edit with more nodes than a scene allows is discarded.
void TissuePanel::apply(const TransferFunction& function, bool moving) {
    if (function.nodes.size() > TransferFunction::kMostNodes)
        return showFunction();
    function_ = function;
    shape_.setBasis(editor_.points(), histogram_);
    showPoint();
    emit transferFunctionEdited(function_, moving);
}

void TissuePanel::editCurve(bool moving) {
    shape_.setFree();
    beginWith(editor_);
    apply(withCurve(base_, channel(), editor_.points()), moving);
}

void TissuePanel::editColours(bool moving) {
    beginWith(strip_);
    editor_.setColours(strip_.stops());
    apply(withColours(base_, strip_.stops()), moving);
}

void TissuePanel::chooseShape(const CurveShape& shape) {
    const Histogram none;
    const float height = heightOf(editor_.points()), top = height > 0 ? height : float(editor_.view().top());
    const Curve curve = curveOf(shape, top, histogram_ ? *histogram_ : none);
    function_ = base_ = withCurve(base_, channel(), curve);
    showCurve();
    apply(function_, false);
}

void TissuePanel::chooseDensity(double extinctionPerMm) {
    function_.extinctionPerMm = base_.extinctionPerMm = float(extinctionPerMm);
    showCurve();
    apply(function_, false);
}

void TissuePanel::typeHu(double hu) {
    if (edited_->selection().empty())
        return;
    const CurvePoint& first = edited_->points()[edited_->selection().front()];
    edited_->nudge({float(hu) - first.hu, 0});
}

/// Sets the value of the selected point, and extends the axis if necessary.
void TissuePanel::typeValue(double value) {
    if (editor_.selection().empty())
        return;
    if (channel() == TissueChannel::opacity && value > double(function_.extinctionPerMm)) {
        function_ = base_ = withRoomFor(function_, float(value));
        showFunction();
    }
    const CurvePoint& first = editor_.points()[editor_.selection().front()];
    editor_.nudge({0, float(value / editor_.unit()) - first.value});
}

}  // namespace pdr::ui
