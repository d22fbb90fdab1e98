#pragma once
/// Rows of the panel of render nodes, with a value in every cell.

#include "ui/nodes/node_row.h"

namespace pdr::test {

inline ui::NodeRow node(quint64 id, ui::NodeState state = ui::NodeState::rendering) {
    ui::NodeRow row;
    row.id = id;
    row.address = QString("10.0.0.%1:4743").arg(id);
    row.name = QString("gpu-%1").arg(id);
    row.device = "cpu, 16 threads";
    row.state = state;
    row.iterationsPerSecond = 2.5;
    row.efficiency = 0.971;
    row.share = 0.125;
    row.latencyMs = 3.25;
    row.bytesSent = 256'000'000;
    row.bytesReceived = 1'500'000;
    row.faults = {.lost = 1, .overdue = 2};
    return row;
}

inline QList<ui::NodeRow> nodes(int count) {
    QList<ui::NodeRow> rows;
    for (int i = 1; i <= count; ++i)
        rows << node(quint64(i));
    return rows;
}

}  // namespace pdr::test
