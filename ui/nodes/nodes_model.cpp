#include "ui/nodes/nodes_model.h"

#include <QHash>
#include <algorithm>
#include <array>

#include "ui/nodes/node_text.h"
#include "ui/text/language.h"

namespace pdr::ui {
namespace {

struct ColumnText {
    const char* title;
    const char* explanation;
};

const std::array<ColumnText, NodesModel::kColumns> kTexts{
    {{QT_TRANSLATE_NOOP("NodesModel", "Render node"),
      QT_TRANSLATE_NOOP("NodesModel", "Its name and where it is reached")},
     {QT_TRANSLATE_NOOP("NodesModel", "State"),
      QT_TRANSLATE_NOOP("NodesModel", "What it is doing. What a lost node had in hand is rendered by others")},
     {QT_TRANSLATE_NOOP("NodesModel", "Device"), QT_TRANSLATE_NOOP("NodesModel", "What it computes with")},
     {QT_TRANSLATE_NOOP("NodesModel", "Iterations/s"),
      QT_TRANSLATE_NOOP("NodesModel", "Of the whole image, that its samples come to")},
     {QT_TRANSLATE_NOOP("NodesModel", "E"),
      QT_TRANSLATE_NOOP("NodesModel", "Efficiency: the part of its time that went into samples")},
     {QT_TRANSLATE_NOOP("NodesModel", "Share"),
      QT_TRANSLATE_NOOP("NodesModel", "Of the image's samples, that it took: what it adds to the error curve")},
     {QT_TRANSLATE_NOOP("NodesModel", "Latency"),
      QT_TRANSLATE_NOOP("NodesModel", "From a question to its answer [milliseconds]")},
     {QT_TRANSLATE_NOOP("NodesModel", "Sent"), QT_TRANSLATE_NOOP("NodesModel", "Bytes to the node")},
     {QT_TRANSLATE_NOOP("NodesModel", "Received"), QT_TRANSLATE_NOOP("NodesModel", "Bytes from the node")},
     {QT_TRANSLATE_NOOP("NodesModel", "Faults"),
      QT_TRANSLATE_NOOP("NodesModel", "What went wrong with it, and was put right by others")}}};

QString percentText(double part) {
    return part > 0 ? NodesModel::tr("%1 %").arg(number(100 * part, part < 0.0995 ? 1 : 0)) : QString();
}

QString cellText(const NodeRow& row, int column) {
    switch (column) {
        case NodesModel::node:
            return nodeName(row);
        case NodesModel::state:
            return nodeStateText(row);
        case NodesModel::device:
            return row.device;
        case NodesModel::iterations:
            return row.iterationsPerSecond > 0 ? number(row.iterationsPerSecond, row.iterationsPerSecond < 9.95 ? 2 : 0)
                                               : QString();
        case NodesModel::efficiency:
            return percentText(row.efficiency);
        case NodesModel::share:
            return percentText(row.share);
        case NodesModel::latency:
            return row.latencyMs < 0 ? QString()
                                     : NodesModel::tr("%1 ms").arg(number(row.latencyMs, row.latencyMs < 9.95));
        case NodesModel::sent:
            return bytesText(row.bytesSent);
        case NodesModel::received:
            return bytesText(row.bytesReceived);
        default:
            return row.faults.all() > 0 ? QString::number(row.faults.all()) : QString();
    }
}

/// Returns the tool tip, for cells that are too narrow or show only a figure.
QString tipText(const NodeRow& row, int column) {
    return column == NodesModel::faults ? faultsText(row.faults) : cellText(row, column);
}

bool isFigure(int column) {
    return column >= NodesModel::iterations;
}

}  // namespace

QString NodesModel::widest(int column) {
    static const std::array<const char*, kColumns> kWidest{"",       "",         "",         "8888.8",   "100 %",
                                                           "88.8 %", "888.8 ms", "888.8 MB", "888.8 MB", "8888"};
    return kWidest[std::size_t(column)];
}

void NodesModel::setNodes(const QList<NodeRow>& nodes) {
    removeThoseWithout(nodes);
    // Update the rows that have changed
    QHash<quint64, const NodeRow*> newest;
    for (const NodeRow& one : nodes)
        newest[one.id] = &one;
    int first = -1, last = -1;
    for (int i = 0; i < int(nodes_.size()); ++i)
        if (const NodeRow& row = *newest.take(nodes_[i].id); nodes_[i] != row) {
            nodes_[i] = row;
            first = first < 0 ? i : first;
            last = i;
        }
    if (last >= 0)
        emit dataChanged(index(first, 0), index(last, kColumns - 1));
    // Append the new nodes
    QList<NodeRow> added;
    for (const NodeRow& one : nodes)
        if (newest.contains(one.id))
            added << one;
    append(added);
}

void NodesModel::removeThoseWithout(const QList<NodeRow>& nodes) {
    for (int i = int(nodes_.size()) - 1; i >= 0; --i)
        if (std::ranges::find(nodes, nodes_[i].id, &NodeRow::id) == nodes.end()) {
            beginRemoveRows({}, i, i);
            nodes_.removeAt(i);
            endRemoveRows();
        }
}

void NodesModel::append(const QList<NodeRow>& nodes) {
    if (nodes.isEmpty())
        return;
    beginInsertRows({}, int(nodes_.size()), int(nodes_.size() + nodes.size()) - 1);
    nodes_ += nodes;
    endInsertRows();
}

QVariant NodesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= nodes_.size())
        return {};
    const NodeRow& row = nodes_[index.row()];
    switch (role) {
        case Qt::DisplayRole:
            return cellText(row, index.column());
        case Qt::ToolTipRole:
            return tipText(row, index.column());
        case Qt::AccessibleTextRole:
            return index.column() == node ? nodeSentence(row) : tipText(row, index.column());
        case Qt::TextAlignmentRole:
            return int((isFigure(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        default:
            return {};
    }
}

QVariant NodesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= kColumns)
        return {};
    const ColumnText& text = kTexts[std::size_t(section)];
    if (role == Qt::DisplayRole)
        return tr(text.title);
    if (role == Qt::ToolTipRole)
        return tr(text.explanation);
    if (role == Qt::TextAlignmentRole)
        return int((isFigure(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

}  // namespace pdr::ui
