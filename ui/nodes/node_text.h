#pragma once
/// What is said of nodes, in words and figures of the window's language.

#include <QList>
#include <QString>

#include "ui/nodes/node_row.h"

namespace pdr::ui {

/// "gpu-07 (10.0.0.7:4743)", or the address alone where there is no name yet.
QString nodeName(const NodeRow& node);
/// "Sending the scan, 45 %", "Lost: the connection was cut". What asks for a look has a mark before it.
QString nodeStateText(const NodeRow& node);
/// "1.5 MB"; nothing of none.
QString bytesText(quint64 bytes);
/// "connections lost: 3, results that never came: 1"; nothing where there are none.
QString faultsText(const NodeFaults& faults);
/// All that is known of the node in a sentence, for those who hear it.
QString nodeSentence(const NodeRow& node);
/// Whether all nodes make the same bits as this machine, and what of it; nothing without nodes that are known.
QString bitsText(const QList<NodeRow>& nodes);

}  // namespace pdr::ui
