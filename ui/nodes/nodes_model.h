#pragma once
/// The table model of the nodes: a row each, in the order in which they were added. An update changes cells in place,
/// so that the selection stays.

#include <QAbstractTableModel>

#include "ui/nodes/node_row.h"

namespace pdr::ui {

class NodesModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { node, state, device, iterations, efficiency, share, latency, sent, received, faults, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Sets the nodes, whose ids must be unique. New ones are added at the end.
    void setNodes(const QList<NodeRow>& nodes);
    const QList<NodeRow>& nodes() const { return nodes_; }

    /// Returns the longest text expected in `column`. Empty: the column takes the remaining width.
    static QString widest(int column);

    int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : int(nodes_.size()); }
    int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    void removeThoseWithout(const QList<NodeRow>& nodes);
    void append(const QList<NodeRow>& nodes);

    QList<NodeRow> nodes_;
};

}  // namespace pdr::ui
