#pragma once
/// Records when render nodes joined and left, for the error plot of the current image. A node that only falls silent
/// causes no event: it may still deliver its results.

#include <QHash>
#include <QList>
#include <cstdint>

#include "ui/accuracy/plot_event.h"
#include "ui/nodes/node_row.h"

namespace pdr::app {

class NodeEvents {
  public:
    /// Records changes. `nodes`: all current nodes. `image`: the revision being rendered, on which `seconds` have
    /// been spent; a new revision starts without events.
    void follow(const QList<ui::NodeRow>& nodes, std::uint64_t image, double seconds);
    /// The last events, at most kMost, in order of time.
    const ui::PlotEvents& events() const { return events_; }

    static constexpr std::size_t kMost = 200;

  private:
    void add(double seconds, const QString& text, bool joined);

    QHash<quint64, ui::NodeRow> takingPart_;  ///< by id, as last reported
    std::uint64_t image_ = 0;
    ui::PlotEvents events_;
};

}  // namespace pdr::app
