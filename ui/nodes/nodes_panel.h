#pragma once
/// The panel of remote render nodes: which they are, what each does and contributes, and what went wrong with it. Nodes
/// are added by their address or dial in, and are paused and removed. Setters emit no signals.

#include <QBoxLayout>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <optional>

#include "ui/nodes/address_row.h"
#include "ui/nodes/listen_row.h"
#include "ui/nodes/nodes_model.h"
#include "ui/nodes/split_box.h"
#include "ui/widgets/elided_label.h"

namespace pdr::ui {

class NodesPanel : public QWidget {
    Q_OBJECT

  public:
    explicit NodesPanel(QWidget* parent = nullptr);

    /// Sets all nodes, whose ids must be unique. The selection stays.
    void setNodes(const QList<NodeRow>& nodes);
    /// Sets which split of the work is in use and why: "Tiles: an iteration takes 0.4 s". Empty: there is no work.
    void setSplit(const QString& sentence);
    /// Sets what was checked of the image's tiles: "2.1 % of 4096 tiles were rendered twice". Empty: there are none.
    void setChecks(const QString& sentence);
    /// Sets whether all that nodes send is rendered twice.
    void setChecksAll(bool all) { checksAll_.setChecked(all); }
    /// Sets the split that the user has chosen. None: chosen by cost.
    void setWantedSplit(std::optional<Split> split) { splitBox_.setSplit(split); }
    /// Sets the port on which nodes may dial in. None: none may.
    void setListening(std::optional<quint16> port) { listen_.setListening(port); }
    /// Sets the folder of this machine's certificates. Empty: there are none, and connections are not encrypted.
    void setBundle(const QString& folder);
    /// Shows what failed, in a sentence; it disappears with the next edit. Empty: nothing.
    void setProblem(const QString& sentence);

    QTableView& table() { return table_; }

    QSize sizeHint() const override { return {760, QWidget::sizeHint().height()}; }

  signals:
    /// Requests to add the node at `address`: "gpu-07:4743".
    void addRequested(const QString& address);
    void removeRequested(quint64 id);
    /// Requests to pause or resume a node. `paused`: it gets no more leases.
    void pauseRequested(quint64 id, bool paused);
    /// Requests to listen on `port`. None: nodes may no longer dial in.
    void listenRequested(const std::optional<quint16>& port);
    /// Requests to use the certificates in `folder`. Empty: none.
    void bundleRequested(const QString& folder);
    /// Requests a split of the work. None: chosen by cost.
    void splitRequested(const std::optional<pdr::Split>& split);
    /// Requests that all that nodes send is rendered twice, or some of it.
    void checksAllRequested(bool all);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void describe();
    void layOut();
    void connectControls();
    void setUpTable();
    QList<NodeRow> selected() const;
    bool allPaused() const;
    void enableWhatCounts();
    void pauseOrGoOn();
    void removeSelected();
    void showNotes();

    NodesModel model_;
    QTableView table_;
    AddressRow address_;
    ListenRow listen_;
    QPushButton pause_;
    QPushButton remove_;
    SplitBox splitBox_;
    QCheckBox checksAll_;
    QBoxLayout* controlGroups_;  ///< side by side where there is room
    QBoxLayout* lastLines_;      ///< side by side where there is room
    QLabel problem_;
    ElidedLabel security_;
    ElidedLabel notes_;
    QString split_, checks_;
};

}  // namespace pdr::ui
