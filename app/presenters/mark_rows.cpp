#include "app/presenters/mark_rows.h"

#include <array>
#include <utility>

#include "app/plan/measured.h"
#include "ui/text/room_text.h"

namespace pdr::app {
ui::MarkShape shapeOf(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::lines:
            return ui::MarkShape::lines;
        case MeasureKind::ball:
            return ui::MarkShape::ball;
        case MeasureKind::ellipse:
            return ui::MarkShape::ellipse;
        case MeasureKind::polygon:
            return ui::MarkShape::polygon;
        default:
            return ui::MarkShape::path;
    }
}

void MarkRows::clear() {
    *this = {};
}

const MarkRows::Known& MarkRows::knownOf(const Measurement& measurement, const Volume& volume) {
    Known& known = known_[measurement.id];
    if (std::exchange(known.measurement, measurement) == measurement)
        return known;
    if (const Result<Measured> found = measured(measurement, volume)) {
        known.value = ui::inWords(found->text);
        known.details = ui::inWords(found->details);
    } else {
        known.value = ui::inWords(found.error().what);
        known.details = ui::inWords(found.error().hint);
    }
    return known;
}

/// Those that were removed stay known: undo brings them back.
void MarkRows::make(const std::vector<Measurement>& measurements, const Volume& volume, std::uint64_t selected,
                    std::uint64_t moving) {
    rows_.clear();
    marks_.clear();
    std::array<int, kMeasureKinds> numbers{};
    for (const Measurement& measurement : measurements) {
        const int number = ++numbers[std::size_t(measurement.kind)];
        const bool waits = measurement.id == moving && isRegion(measurement.kind);
        const Known known = waits ? Known{measurement, QString::fromUtf8("…"), {}} : knownOf(measurement, volume);
        const QString name = measurement.name.empty() ? ui::inWords(ordinalName(measurement.kind, number))
                                                      : QString::fromStdString(measurement.name);
        rows_.push_back({measurement.id, name, known.value, known.details});
        ui::ShownMark mark{.id = measurement.id,
                           .shape = shapeOf(measurement.kind),
                           .text = measurement.kind == MeasureKind::point ? name : known.value,
                           .selected = measurement.id == selected};
        for (const measure::Place& place : measurement.places)
            mark.placesMm.push_back(place.mm);
        marks_.push_back(std::move(mark));
    }
}

}  // namespace pdr::app
