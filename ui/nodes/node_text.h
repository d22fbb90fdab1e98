#pragma once
/// Texts and figures about nodes in the window's language.

#include <QList>
#include <QString>

#include "ui/nodes/node_row.h"

namespace pdr::ui {

/// Returns "gpu-07 (10.0.0.7:4743)", or the address alone while there is no name.
QString nodeName(const NodeRow& node);
/// Returns the state: "Sending the scan, 45 %", "Lost: the connection was cut". A state that needs attention begins
/// with a warning sign.
QString nodeStateText(const NodeRow& node);
/// Returns "1.5 MB"; empty for 0 bytes.
QString bytesText(quint64 bytes);
/// Returns "connections lost: 3, results that never came: 1"; empty if there are none.
QString faultsText(const NodeFaults& faults);
/// Returns all that is known of the node in one sentence, for screen readers.
QString nodeSentence(const NodeRow& node);
/// Returns whether all nodes compute the same bits as this machine, and what follows from it; empty without known
/// nodes.
QString bitsText(const QList<NodeRow>& nodes);

}  // namespace pdr::ui
