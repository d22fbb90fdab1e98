#pragma once
/// The machines that render along: who they are, what each does and adds, and what went wrong with it. Nodes are added
/// by their address or dial in, and are paused and removed. Setters are silent.

#include <QBoxLayout>
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

    /// All of them; what is selected stays so. No two have the same id.
    void setNodes(const QList<NodeRow>& nodes);
    /// Which split of the work is in use and why: "Tiles: an iteration takes 0.4 s"; empty: there is no work.
    void setSplit(const QString& sentence);
    /// That the user wants; none: as its costs say.
    void setWantedSplit(std::optional<Split> split) { splitBox_.setSplit(split); }
    /// None: nobody may dial in.
    void setListening(std::optional<quint16> port) { listen_.setListening(port); }
    /// The folder of this machine's certificates; empty: there are none, and connections are plain.
    void setBundle(const QString& folder);
    /// What could not be done, in a sentence; it goes with the next edit. Empty: nothing.
    void setProblem(const QString& sentence);

    QTableView& table() { return table_; }

    QSize sizeHint() const override { return {760, QWidget::sizeHint().height()}; }

  signals:
    /// "gpu-07:4743"
    void addRequested(const QString& address);
    void removeRequested(quint64 id);
    /// `paused`: it is to take no more leases.
    void pauseRequested(quint64 id, bool paused);
    /// None: nobody may dial in any more.
    void listenRequested(const std::optional<quint16>& port);
    /// Empty: certificates are no longer to be used.
    void bundleRequested(const QString& folder);
    /// None: as its costs say.
    void splitRequested(const std::optional<pdr::Split>& split);

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
    QBoxLayout* controlGroups_;  ///< side by side where there is room
    QBoxLayout* lastLines_;      ///< the same
    QLabel problem_;
    ElidedLabel security_;
    ElidedLabel notes_;
    QString split_;
};

}  // namespace pdr::ui
