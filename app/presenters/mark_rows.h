#pragma once
/// The measurements of a plan as the list and the views show them. Values are computed once for each measurement as it
/// is: those of a large region take a while.

#include <map>

#include "app/plan/measurement.h"
#include "render/volume/volume.h"
#include "ui/measure/marks_panel.h"
#include "ui/measure/shown_mark.h"

namespace pdr::app {

/// Returns what is drawn between the places of a measurement.
ui::MarkShape shapeOf(MeasureKind kind);

class MarkRows {
  public:
    /// Makes rows and marks of `measurements` in `volume`. `selected`: id of the one that is chosen. `moving`: id of
    /// the one whose place is being dragged, 0 for none; the statistics of a region come when it rests.
    void make(const std::vector<Measurement>& measurements, const Volume& volume, std::uint64_t selected,
              std::uint64_t moving);
    /// Forgets all, since there is another volume, or none.
    void clear();

    const std::vector<ui::MarkRow>& rows() const { return rows_; }
    const std::vector<ui::ShownMark>& marks() const { return marks_; }

  private:
    /// What a measurement was found to say.
    struct Known {
        Measurement measurement;
        QString value, details;
    };
    const Known& knownOf(const Measurement& measurement, const Volume& volume);

    std::map<std::uint64_t, Known> known_;
    std::vector<ui::MarkRow> rows_;
    std::vector<ui::ShownMark> marks_;
};

}  // namespace pdr::app
