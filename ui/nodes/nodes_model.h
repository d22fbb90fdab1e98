#pragma once
/// The nodes as a table: a row each, in the order in which they came. An update changes cells where they stand, so that
/// what is selected stays so.

#include <QAbstractTableModel>

#include "ui/nodes/node_row.h"

namespace pdr::ui {

class NodesModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { node, state, device, iterations, efficiency, share, latency, sent, received, faults, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// No two of them have the same id. Those that are new stand at the end.
    void setNodes(const QList<NodeRow>& nodes);
    const QList<NodeRow>& nodes() const { return nodes_; }

    /// As long as any that is to be expected in that column; empty: it takes what room there is.
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
