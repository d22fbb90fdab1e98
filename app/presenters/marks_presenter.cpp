#include "app/presenters/marks_presenter.h"

#include <algorithm>
#include <random>
#include <utility>

#include "app/plan/slice_region.h"
#include "app/presenters/crosshair_presenter.h"
#include "app/presenters/mark_places.h"
#include "app/presenters/mark_profile.h"
#include "app/presenters/slices_presenter.h"
#include "render/measure/trilinear.h"

namespace pdr::app {
namespace {

constexpr const char* kPanel = "Measurements";

std::uint64_t newId() {
    std::random_device random;
    return std::uint64_t(random()) << 32 | random();
}

auto find(auto& measurements, std::uint64_t id) {
    return std::ranges::find(measurements, id, &Measurement::id);
}

/// Returns what was typed as a name, no longer than a plan file holds.
std::string nameOf(const QString& typed) {
    QString name = typed.trimmed();
    while (std::size_t(name.toUtf8().size()) > kLongestName)
        name.chop(1);
    return name.toStdString();
}

}  // namespace

MarksPresenter::MarksPresenter(const Workspace& workspace, SlicesPresenter& slices, const CrosshairPresenter& crosshair,
                               PlaceScenes& scenes)
    : Presenter(workspace), slices_(slices), panel_(new ui::MarksPanel), inImage_(workspace, scenes) {
    window().addPanel(panel_, {kPanel, ui::WindowDocks::tr("Measurements"), QKeySequence(Qt::CTRL | Qt::Key_M)});
    tools_ = new MarkTools(slices_.menu(), *panel_, window());
    tools_->setParent(this);
    connect(tools_, &MarkTools::chosen, this, &MarksPresenter::draw);
    for (const AnatomicalPlane plane : kAnatomicalPlanes)
        connectLayer(plane);
    connectChoices(inImage());
    connect(&inImage_, &ImageMarks::moved, this, &MarksPresenter::moveInImage);
    connect(&crosshair.picks(), &ImagePick::picked, this, [this](const PickedPlace& picked) {
        if (drawing_ && !isFlat(*drawing_))
            place(placeInImage(*document().seen(), picked, isBetweenEdges(*drawing_) && !picked.free));
    });
    connectPanel();
}

void MarksPresenter::connectLayer(AnatomicalPlane plane) {
    ui::SliceView& view = slices_.view(plane);
    ui::MarksLayer& layer = layers_[std::size_t(plane)];
    view.tools().add(layer);
    connect(&layer, &ui::MarksLayer::placed, this, [this, &view](dvec3 placeMm, bool free) {
        if (view.slice())
            placeOn(view.slice()->plane, placeMm, free);
    });
    connect(&layer, &ui::MarksLayer::takenBack, this, &MarksPresenter::takeBack);
    connect(&layer, &ui::MarksLayer::closed, this, &MarksPresenter::finish);
    connect(&layer, &ui::MarksLayer::dragged, this,
            [this, &view](std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving) {
                if (view.slice())
                    drag(view.slice()->plane, id, index, placeMm, free, moving);
            });
    connect(&layer, &ui::MarksLayer::dragCancelled, this, [this] {
        moving_ = 0;
        document().giveUpGesture();
    });
    connectChoices(layer);
}

/// Connects what the layers of slices and of the image have in common.
void MarksPresenter::connectChoices(ui::MarksLayer& layer) {
    connect(&layer, &ui::MarksLayer::selected, this, [this](std::uint64_t id) {
        selected_ = id;
        show();
    });
    connect(&layer, &ui::MarksLayer::drawingCancelled, this, [this] { draw(std::nullopt); });
}

void MarksPresenter::connectPanel() {
    connect(panel_, &ui::MarksPanel::selected, this, &MarksPresenter::select);
    connect(panel_, &ui::MarksPanel::renamed, this, &MarksPresenter::rename);
    connect(panel_, &ui::MarksPanel::removed, this, &MarksPresenter::remove);
}

/// Begins to draw a measurement on slices and in the image, or ends drawing.
void MarksPresenter::draw(std::optional<MeasureKind> kind) {
    drawing_ = document().hasVolume() ? kind : std::nullopt;
    drawn_.clear();
    if (drawing_) {
        slices_.showSlices();
        slices_.focusOne();  // where Enter sets a place
    }
    tools_->setDrawing(drawing_);
    for (ui::MarksLayer& layer : layers_)
        layer.setDrawing(drawing_.has_value());
    inImage().setDrawing(drawing_.has_value());
    showDrawn();
}

/// Sets the next place where a slice was clicked. What is flat stays in the plane of its first place, wherever the
/// slices have gone since.
void MarksPresenter::placeOn(const SlicePlane& plane, dvec3 placeMm, bool free) {
    if (!drawing_ || !isInScan(placeMm))
        return;
    if (drawn_.empty())
        drawnNormal_ = plane.normal();
    const bool toEdge = isBetweenEdges(*drawing_) && !free;
    if (isFlat(*drawing_) && !drawn_.empty())
        place(placeInPlane(*document().seen(), plane, placeMm, toEdge, drawn_[0].mm, drawnNormal_));
    else
        place(placeOnSlice(*document().seen(), plane, placeMm, toEdge));
}

bool MarksPresenter::isInScan(dvec3 placeMm) const {
    return measure::GridPlace(document().seen()->geometry()).contains(placeMm);
}

void MarksPresenter::showDrawn() {
    std::vector<dvec3> places;
    for (const measure::Place& place : drawn_)
        places.push_back(place.mm);
    const ui::MarkShape shape = drawing_ ? shapeOf(*drawing_) : ui::MarkShape::path;
    const bool byEnter = drawnAt_ == document().plan().navigation.crosshairMm;  // else Enter sets a corner there
    for (ui::MarksLayer& layer : layers_) {
        layer.setDrawn(shape, places);
        layer.setClosing(mayClose(), mayClose() && byEnter);
    }
    inImage().setDrawn(shape, places);
}

/// Sets the next place of what is being drawn; the last one makes a measurement of it.
void MarksPresenter::place(const measure::Place& place) {
    if (drawn_.size() >= mostPlacesOf(*drawing_))
        return showError({phrase("a polygon has %1 corners at most", kMostCorners), "",
                          phrase("Close it with Enter, or take corners back with Backspace."), ErrorKind::refused});
    drawn_.push_back(place);
    drawnAt_ = document().plan().navigation.crosshairMm;
    if (*drawing_ == MeasureKind::polygon || drawn_.size() < placesOf(*drawing_))
        return showDrawn();
    finish();
}

/// Takes back the last place of what is being drawn.
void MarksPresenter::takeBack() {
    if (drawn_.empty())
        return;
    drawn_.pop_back();
    showDrawn();
}

/// Returns whether what is being drawn is a polygon that has enough corners.
bool MarksPresenter::mayClose() const {
    return drawing_ == MeasureKind::polygon && drawn_.size() >= placesOf(MeasureKind::polygon);
}

/// Makes a measurement of what has been drawn.
void MarksPresenter::finish() {
    Measurement measurement{newId(), *drawing_, {}, std::exchange(drawn_, {})};
    settle(measurement);
    draw(std::nullopt);
    add(std::move(measurement));
}

void MarksPresenter::add(Measurement measurement) {
    Plan plan = document().plan();
    if (plan.measurements.size() >= kMostMeasurements)
        return showError({phrase("a plan holds %1 measurements at most", kMostMeasurements), "",
                          phrase("Remove some of them."), ErrorKind::refused});
    selected_ = measurement.id;
    const bool isPoint = measurement.kind == MeasureKind::point;
    plan.measurements.push_back(std::move(measurement));
    document().edit(std::move(plan));
    if (isPoint)
        askForName(selected_);
}

/// Opens the name of a new label for typing.
void MarksPresenter::askForName(std::uint64_t id) {
    QAction* toggle = window().panelToggle(kPanel);
    if (!toggle->isChecked())
        toggle->trigger();
    panel_->editName(id);
}

/// Moves a place. It goes to an edge only when the button is released, so that it does not jump under the pointer.
void MarksPresenter::drag(const SlicePlane& plane, std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving) {
    Plan plan = document().plan();
    const auto measurement = find(plan.measurements, id);
    if (measurement == plan.measurements.end() || !isInScan(placeMm))
        return;
    const bool toEdge = isBetweenEdges(measurement->kind) && !free && !moving;
    const auto normal = isFlat(measurement->kind) ? normalOf(measurement->places) : std::nullopt;
    movePlace(*measurement, std::size_t(index),
              normal ? placeInPlane(*document().seen(), plane, placeMm, toEdge, measurement->places[0].mm, *normal)
                     : placeOnSlice(*document().seen(), plane, placeMm, toEdge));
    moving_ = moving ? id : 0;
    document().edit(std::move(plan), Changes::measurements, moving);
    if (!moving)
        show();  // also if it ended where it was
}

void MarksPresenter::moveInImage(std::uint64_t id, int index, const PickedPlace& picked) {
    Plan plan = document().plan();
    const auto measurement = find(plan.measurements, id);
    if (measurement == plan.measurements.end())
        return;
    const bool toEdge = isBetweenEdges(measurement->kind) && !picked.free;
    movePlace(*measurement, std::size_t(index), placeInImage(*document().seen(), picked, toEdge));
    document().edit(std::move(plan));
    show();  // also if it ended where it was
}

void MarksPresenter::rename(std::uint64_t id, const QString& name) {
    Plan plan = document().plan();
    const auto measurement = find(plan.measurements, id);
    if (measurement == plan.measurements.end())
        return;
    measurement->name = nameOf(name);
    document().edit(std::move(plan));
}

void MarksPresenter::remove(std::uint64_t id) {
    Plan plan = document().plan();
    if (std::erase_if(plan.measurements, [id](const Measurement& one) { return one.id == id; }))
        document().edit(std::move(plan));
}

/// Selects a measurement, and moves the slices to its first place.
void MarksPresenter::select(std::uint64_t id) {
    selected_ = id;
    const std::vector<Measurement>& all = document().plan().measurements;
    if (const auto chosen = find(all, id); chosen != all.end())
        document().moveCrosshair(chosen->places.front().mm);
    show();
}

void MarksPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        draw(std::nullopt);
        panel_->setEnabled(document().hasVolume());
        tools_->setEnabled(document().hasVolume());
    }
    if (has(changes, Changes::crosshair) && mayClose())
        showDrawn();
    if (has(changes, Changes::series | Changes::table))
        rows_.clear();
    if (has(changes, Changes::series | Changes::table | Changes::measurements))
        show();
    inImage_.showDocument(changes);
}

void MarksPresenter::releaseVolume() {
    draw(std::nullopt);
    inImage_.releaseVolume();
}

void MarksPresenter::show() {
    if (document().hasVolume())
        rows_.make(document().plan().measurements, *document().seen(), selected_, moving_);
    else
        rows_.clear();
    panel_->setRows(rows_.rows());
    panel_->setSelected(selected_);
    showProfile();
    for (ui::MarksLayer& layer : layers_)
        layer.setMarks(rows_.marks());
    inImage_.setMarks(rows_.marks());
}

/// Shows the HU along the selected measurement, if it is a distance.
void MarksPresenter::showProfile() {
    const std::vector<Measurement>& all = document().plan().measurements;
    const auto chosen = find(all, selected_);
    const bool shown = document().hasVolume() && chosen != all.end();
    panel_->setProfile(shown ? profileOf(*chosen, *document().seen()) : std::nullopt);
}

}  // namespace pdr::app
