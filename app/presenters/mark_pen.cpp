#include "app/presenters/mark_pen.h"

#include "app/plan/slice_region.h"
#include "app/presenters/crosshair_presenter.h"
#include "app/presenters/mark_places.h"
#include "app/presenters/mark_rows.h"
#include "app/presenters/slices_presenter.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Marks)
};

}  // namespace

MarkPen::MarkPen(const Workspace& workspace, SlicesPresenter& slices, CrosshairPresenter& crosshair,
                 ui::MarksPanel& panel)
    : workspace_(workspace), slices_(slices), crosshair_(crosshair), tools_(slices.menu(), panel, workspace.window) {
    connect(&tools_, &MarkTools::chosen, this, &MarkPen::draw);
}

void MarkPen::addSlice(AnatomicalPlane axis, ui::MarksLayer& layer) {
    connect(&layer, &ui::MarksLayer::placed, this, [this, axis](dvec3 placeMm, bool free) {
        if (const auto& slice = slices_.view(axis).slice())
            placeOn({axis, slice->plane}, placeMm, free);
    });
    connect(&layer, &ui::MarksLayer::takenBack, this, &MarkPen::takeBack);
    connect(&layer, &ui::MarksLayer::closed, this, &MarkPen::finish);
    ofSlices_[axis] = &layer;
    add(layer);
}

void MarkPen::addImage(ui::MarksLayer& layer) {
    connect(&crosshair_.picks(), &ImagePick::picked, this, [this](const PickedPlace& picked) {
        if (!drawing_ || isFlat(drawing_->kind()))
            return;
        drawing_->add(placeInImage(*document().seen(), picked, isBetweenEdges(drawing_->kind()) && !picked.free));
        goOn();
    });
    connect(&workspace_.window.viewport(), &ui::Viewport::clicked, this, [this] {
        if (drawing_ && isFlat(drawing_->kind()))
            sayWhere();
    });
    add(layer);
}

void MarkPen::add(ui::MarksLayer& layer) {
    layers_.push_back(&layer);
    connect(&layer, &ui::MarksLayer::drawingCancelled, this, &MarkPen::stop);
}

void MarkPen::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        stop();
        tools_.setEnabled(document().hasVolume());
    }
    if (has(changes, Changes::crosshair) && drawing_ && drawing_->mayClose())
        show();
}

/// Begins to draw a measurement on slices and in the image, or ends drawing. Clicks on the image then leave the
/// crosshair where it is if they set no place: the slices would leave the figure.
void MarkPen::draw(std::optional<MeasureKind> kind) {
    drawing_.reset();
    if (kind && document().hasVolume())
        drawing_.emplace(*kind);
    if (drawing_) {
        slices_.showSlices();
        slices_.focusOne();  // where Enter sets a place
    }
    crosshair_.setFollowsClicks(!drawing_ || !isFlat(drawing_->kind()));
    tools_.setDrawing(drawing_ ? std::optional(drawing_->kind()) : std::nullopt);
    for (ui::MarksLayer* layer : layers_)
        layer->setDrawing(drawing_.has_value());
    show();
}

/// Sets the next place where a slice was clicked.
void MarkPen::placeOn(const ViewedSlice& slice, dvec3 placeMm, bool free) {
    if (!drawing_ || !isInScan(*document().seen(), placeMm))
        return;
    if (drawing_->isFull())
        return workspace_.window.message().showError(
            {phrase("a polygon has %1 corners at most", kMostCorners), "",
             phrase("Close it with Enter, or take corners back with Backspace."), ErrorKind::refused});
    if (!drawing_->goesOnIn(slice, document().seen()->geometry()))
        return sayWhere();
    drawing_->add(*document().seen(), slice, placeMm, free);
    goOn();
}

/// Says where the flat figure is drawn, since a click elsewhere sets no place, and offers to show its slice if it has
/// one.
void MarkPen::sayWhere() {
    const Error error = drawing_->isElsewhere(document().seen()->geometry());
    if (drawing_->places().empty())
        return workspace_.window.status().showForAWhile(ui::sentence(error.text()));
    ui::MessageBar& message = workspace_.window.message();
    message.showError(error);
    message.offer(Texts::tr("Show that slice"),
                  [this, place = drawing_->places().front().mm] { document().moveCrosshair(place); });
}

void MarkPen::show() {
    std::vector<dvec3> places;
    if (drawing_)
        for (const measure::Place& place : drawing_->places())
            places.push_back(place.mm);
    const ui::MarkShape shape = drawing_ ? shapeOf(drawing_->kind()) : ui::MarkShape::path;
    const bool mayClose = drawing_ && drawing_->mayClose();
    const bool byEnter = drawnAt_ == document().plan().navigation.crosshairMm;  // else Enter sets a corner there
    for (ui::MarksLayer* layer : layers_) {
        layer->setDrawn(shape, places);
        layer->setClosing(mayClose, mayClose && byEnter);
    }
    for (const auto& [axis, layer] : ofSlices_)
        layer->setElsewhere(drawing_ && drawing_->liesAcross(axis));
    workspace_.window.message().withdraw(Texts::tr("Show that slice"));
}

/// Goes on after a place was set: the last one makes a measurement of them.
void MarkPen::goOn() {
    drawnAt_ = document().plan().navigation.crosshairMm;
    if (drawing_->isComplete())
        finish();
    else
        show();
}

/// Takes back the last place of what is being drawn.
void MarkPen::takeBack() {
    drawing_->takeBack();
    show();
}

/// Makes a measurement of what has been drawn.
void MarkPen::finish() {
    Measurement measurement{0, drawing_->kind(), {}, drawing_->places()};
    settle(measurement);
    draw(std::nullopt);
    emit drawn(measurement);
}

}  // namespace pdr::app
