#include "app/presenters/marks_presenter.h"

#include <algorithm>
#include <random>
#include <utility>

#include "app/plan/slice_region.h"
#include "app/presenters/mark_places.h"
#include "app/presenters/mark_profile.h"
#include "app/presenters/slices_presenter.h"

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

MarksPresenter::MarksPresenter(const Workspace& workspace, SlicesPresenter& slices, CrosshairPresenter& crosshair,
                               PlaceScenes& scenes)
    : Presenter(workspace),
      panel_(new ui::MarksPanel),
      pen_(workspace, slices, crosshair, *panel_),
      inImage_(workspace, scenes) {
    window().addPanel(panel_, {kPanel, ui::WindowDocks::tr("Measurements"), QKeySequence(Qt::CTRL | Qt::Key_M)});
    for (const AnatomicalPlane axis : kAnatomicalPlanes)
        connectSlice(axis, slices.view(axis));
    connectSelection(inImage());
    connect(&inImage_, &ImageMarks::moved, this, &MarksPresenter::moveInImage);
    pen_.addImage(inImage());
    connect(&pen_, &MarkPen::drawn, this, &MarksPresenter::add);
    connectPanel();
}

void MarksPresenter::connectSlice(AnatomicalPlane axis, ui::SliceView& view) {
    ui::MarksLayer& layer = layers_[std::size_t(axis)];
    view.tools().add(layer);
    pen_.addSlice(axis, layer);
    connect(&layer, &ui::MarksLayer::dragged, this,
            [this, &view](std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving) {
                if (view.slice())
                    drag(view.slice()->plane, id, index, placeMm, free, moving);
            });
    connect(&layer, &ui::MarksLayer::dragCancelled, this, [this] {
        moving_ = 0;
        document().giveUpGesture();
    });
    connectSelection(layer);
}

void MarksPresenter::connectSelection(ui::MarksLayer& layer) {
    connect(&layer, &ui::MarksLayer::selected, this, [this](std::uint64_t id) {
        selected_ = id;
        show();
    });
}

void MarksPresenter::connectPanel() {
    connect(panel_, &ui::MarksPanel::selected, this, &MarksPresenter::select);
    connect(panel_, &ui::MarksPanel::renamed, this, &MarksPresenter::rename);
    connect(panel_, &ui::MarksPanel::removed, this, &MarksPresenter::remove);
}

/// Adds a measurement that has been drawn.
void MarksPresenter::add(Measurement measurement) {
    Plan plan = document().plan();
    if (plan.measurements.size() >= kMostMeasurements)
        return showError({phrase("a plan holds %1 measurements at most", kMostMeasurements), "",
                          phrase("Remove some of them."), ErrorKind::refused});
    selected_ = measurement.id = newId();
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
    if (measurement == plan.measurements.end() || !isInScan(*document().seen(), placeMm))
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
    if (has(changes, Changes::series))
        panel_->setEnabled(document().hasVolume());
    pen_.showDocument(changes);
    if (has(changes, Changes::series | Changes::table))
        rows_.clear();
    if (has(changes, Changes::series | Changes::table | Changes::measurements))
        show();
    inImage_.showDocument(changes);
}

void MarksPresenter::releaseVolume() {
    pen_.stop();
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
