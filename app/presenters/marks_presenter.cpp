#include "app/presenters/marks_presenter.h"

#include <QMenu>
#include <algorithm>
#include <random>
#include <utility>

#include "app/plan/measured.h"
#include "app/presenters/slices_presenter.h"
#include "render/measure/edge.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Marks)
};

std::uint64_t newId() {
    std::random_device random;
    return std::uint64_t(random()) << 32 | random();
}

/// Returns what a measurement without a name is called; `number` counts those of its kind from 1.
QString ordinalName(MeasureKind kind, int number) {
    switch (kind) {
        case MeasureKind::distance:
            return Texts::tr("Distance %1").arg(number);
        case MeasureKind::angle:
            return Texts::tr("Angle %1").arg(number);
        case MeasureKind::lines:
            return Texts::tr("Two lines %1").arg(number);
        case MeasureKind::point:
            return Texts::tr("Place %1").arg(number);
        case MeasureKind::ball:
            break;
    }
    return Texts::tr("Ball %1").arg(number);
}

ui::MarkRow rowOf(const Measurement& measurement, int number, const Volume& volume) {
    const QString name =
        measurement.name.empty() ? ordinalName(measurement.kind, number) : QString::fromStdString(measurement.name);
    const Result<Measured> value = measured(measurement, volume);
    if (!value)
        return {measurement.id, name, ui::inWords(value.error().what), ui::inWords(value.error().hint)};
    return {measurement.id, name, ui::inWords(value->text), ui::inWords(value->details)};
}

auto find(std::vector<Measurement>& measurements, std::uint64_t id) {
    return std::ranges::find(measurements, id, &Measurement::id);
}

}  // namespace

MarksPresenter::MarksPresenter(const Workspace& workspace, SlicesPresenter& slices)
    : Presenter(workspace), slices_(slices), panel_(new ui::MarksPanel) {
    window().addPanel(panel_,
                      {"Measurements", ui::WindowDocks::tr("Measurements"), QKeySequence(Qt::CTRL | Qt::Key_M)});
    fillMenu(slices_.menu());
    window().viewport().tools().add(inImage_);
    for (const AnatomicalPlane plane : kAnatomicalPlanes)
        connectLayer(plane);
    connectPanel();
}

void MarksPresenter::fillMenu(QMenu& menu) {
    menu.addSeparator();
    const auto add = [&](const QString& text, const char* name, Qt::Key key, MeasureKind kind, const QString& toolTip) {
        QAction* action = menu.addAction(text, QKeySequence(key));
        action->setCheckable(true);
        action->setObjectName(name);
        action->setToolTip(toolTip);
        window().addAction(action);  // so that its key works while the menu bar is hidden
        connect(action, &QAction::triggered, this,
                [this, kind](bool drawing) { draw(drawing ? std::optional(kind) : std::nullopt); });
        return action;
    };
    distance_ = add(Texts::tr("&Distance"), "distance", Qt::Key_M, MeasureKind::distance,
                    Texts::tr("Measures between two places of a slice, which move to the edge of a structure."));
    angle_ = add(Texts::tr("&Angle"), "angle", Qt::Key_A, MeasureKind::angle,
                 Texts::tr("Measures at the second of three places of a slice."));
}

void MarksPresenter::connectLayer(AnatomicalPlane plane) {
    ui::SliceView& view = slices_.view(plane);
    ui::MarksLayer& layer = layers_[std::size_t(plane)];
    view.tools().add(layer);
    connect(&layer, &ui::MarksLayer::placed, this, [this, &view](dvec3 placeMm, bool free) {
        if (view.slice())
            place(view.slice()->plane, placeMm, free);
    });
    connect(&layer, &ui::MarksLayer::dragged, this,
            [this, &view](std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving) {
                if (view.slice())
                    drag(view.slice()->plane, id, index, placeMm, free, moving);
            });
    connect(&layer, &ui::MarksLayer::selected, this, [this](std::uint64_t id) {
        selected_ = id;
        show();
    });
    connect(&layer, &ui::MarksLayer::drawingCancelled, this, [this] { draw(std::nullopt); });
}

void MarksPresenter::connectPanel() {
    connect(panel_, &ui::MarksPanel::distanceChosen, distance_, &QAction::trigger);
    connect(panel_, &ui::MarksPanel::angleChosen, angle_, &QAction::trigger);
    connect(panel_, &ui::MarksPanel::selected, this, &MarksPresenter::select);
    connect(panel_, &ui::MarksPanel::renamed, this, &MarksPresenter::rename);
    connect(panel_, &ui::MarksPanel::removed, this, &MarksPresenter::remove);
}

/// Begins to draw a measurement on the slices, or ends drawing.
void MarksPresenter::draw(std::optional<MeasureKind> kind) {
    drawing_ = document().hasVolume() ? kind : std::nullopt;
    drawn_.clear();
    if (drawing_)
        slices_.showSlices();
    distance_->setChecked(drawing_ == MeasureKind::distance);
    angle_->setChecked(drawing_ == MeasureKind::angle);
    panel_->setDrawing(distance_->isChecked(), angle_->isChecked());
    for (ui::MarksLayer& layer : layers_)
        layer.setDrawing(drawing_.has_value());
    showDrawn();
}

void MarksPresenter::showDrawn() {
    std::vector<dvec3> places;
    for (const measure::Place& place : drawn_)
        places.push_back(place.mm);
    for (ui::MarksLayer& layer : layers_)
        layer.setDrawn(places);
}

/// Returns the place of a click on a slice: at the edge of a structure near it, unless it is to stay free.
measure::Place MarksPresenter::placeAt(const SlicePlane& plane, dvec3 placeMm, bool free) const {
    const std::shared_ptr<const Volume> volume = document().seen();
    const measure::Place clicked =
        measure::clickedPlace(volume->geometry(), placeMm, {plane.right, plane.down, plane.mmPerPixel, 0});
    if (free)
        return clicked;
    const measure::EdgeSearch search = measure::edgeNear(*volume, placeMm, plane.normal());
    return search.edge ? measure::atEdge(clicked, *search.edge) : clicked;
}

void MarksPresenter::place(const SlicePlane& plane, dvec3 placeMm, bool free) {
    if (!drawing_ || !document().hasVolume())
        return;
    drawn_.push_back(placeAt(plane, placeMm, free));
    if (drawn_.size() < placesOf(*drawing_))
        return showDrawn();
    Measurement measurement{newId(), *drawing_, {}, std::exchange(drawn_, {})};
    draw(std::nullopt);
    add(std::move(measurement));
}

void MarksPresenter::add(Measurement measurement) {
    selected_ = measurement.id;
    Plan plan = document().plan();
    plan.measurements.push_back(std::move(measurement));
    document().edit(std::move(plan));
}

/// Moves a place. It goes to an edge only when the button is released, so that it does not jump under the pointer.
void MarksPresenter::drag(const SlicePlane& plane, std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving) {
    Plan plan = document().plan();
    const auto measurement = find(plan.measurements, id);
    if (measurement == plan.measurements.end())
        return;
    measurement->places[std::size_t(index)] = placeAt(plane, placeMm, free || moving);
    document().edit(std::move(plan), Changes::measurements, moving);
}

void MarksPresenter::rename(std::uint64_t id, const QString& name) {
    Plan plan = document().plan();
    const auto measurement = find(plan.measurements, id);
    if (measurement == plan.measurements.end())
        return;
    measurement->name = name.trimmed().toStdString();
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
    if (const auto chosen = std::ranges::find(all, id, &Measurement::id); chosen != all.end())
        document().moveCrosshair(chosen->places.front().mm);
    show();
}

void MarksPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        draw(std::nullopt);
        panel_->setEnabled(document().hasVolume());
        distance_->setEnabled(document().hasVolume());
        angle_->setEnabled(document().hasVolume());
    }
    if (has(changes, Changes::series | Changes::measurements))
        show();
}

void MarksPresenter::releaseVolume() {
    draw(std::nullopt);
}

void MarksPresenter::show() {
    std::vector<ui::MarkRow> rows;
    std::vector<ui::ShownMark> marks;
    std::array<int, kMeasureKinds> numbers{};
    if (document().hasVolume())
        for (const Measurement& measurement : document().plan().measurements) {
            const int number = ++numbers[std::size_t(measurement.kind)];
            rows.push_back(rowOf(measurement, number, *document().seen()));
            ui::ShownMark mark{
                .id = measurement.id, .text = rows.back().value, .selected = measurement.id == selected_};
            for (const measure::Place& place : measurement.places)
                mark.placesMm.push_back(place.mm);
            marks.push_back(std::move(mark));
        }
    panel_->setRows(rows);
    panel_->setSelected(selected_);
    for (ui::MarksLayer& layer : layers_)
        layer.setMarks(marks);
    inImage_.setMarks(marks);
}

}  // namespace pdr::app
