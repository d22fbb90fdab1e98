#pragma once
/// When render nodes came and went, for the error plot of the picture in hand. Of a node that only fell silent nothing
/// is said: it may still bring what it has.

#include <QHash>
#include <QList>
#include <cstdint>

#include "ui/accuracy/plot_event.h"
#include "ui/nodes/node_row.h"

namespace pdr::app {

class NodeEvents {
  public:
    /// `nodes`: all that there are now. `picture`: the revision in hand, on which `seconds` have been spent; another
    /// one has no events yet.
    void follow(const QList<ui::NodeRow>& nodes, std::uint64_t picture, double seconds);
    /// The last ones, in the order of time.
    const ui::PlotEvents& events() const { return events_; }

    static constexpr std::size_t kMost = 200;

  private:
    void add(double seconds, const QString& text, bool joined);

    QHash<quint64, ui::NodeRow> takingPart_;  ///< as they were told last
    std::uint64_t picture_ = 0;
    ui::PlotEvents events_;
};

}  // namespace pdr::app
