#pragma once
/// The render nodes of the window: those that are wanted, by hand or from the last time, those that dial in, and what
/// becomes of them. As long as there are none, nothing of it costs anything; with the first one the device of the
/// picture takes samples together with them. Ends with a goodbye to all nodes, which forget what they have.

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/coordinator/render_nodes.h"
#include "app/desktop/node_events.h"
#include "app/desktop/node_figures.h"
#include "app/desktop/render_bridge.h"

namespace pdr::app {

class NodesJob : public QObject {
    Q_OBJECT

  public:
    /// `bridge` must outlive it.
    explicit NodesJob(RenderBridge& bridge);
    ~NodesJob() override;

    /// As of the last change: those that are wanted first.
    const QList<ui::NodeRow>& rows() const { return rows_; }
    const ui::PlotEvents& events() const { return events_.events(); }
    QStringList addresses() const;  ///< of those that are wanted
    std::optional<quint16> port() const { return port_; }
    const QString& bundle() const { return bundle_; }
    std::optional<Split> wantedSplit() const { return split_; }
    /// How their work is split, and why; empty without any.
    QString splitText() const;

  public slots:
    /// Dials it from now on.
    void add(const QString& address);
    void remove(quint64 id);
    void setPaused(quint64 id, bool paused);
    /// None: nobody may dial in.
    void listen(const std::optional<quint16>& port);
    /// The folder of this machine's certificates, for all connections from now on; empty: there are none. Those that
    /// there are begin anew.
    void setBundle(const QString& folder);
    /// Of the work; none: as its costs say.
    void setSplit(const std::optional<pdr::Split>& split);

  signals:
    /// rows() or events() are others; some times a second at most.
    void changed();
    /// addresses(), port(), bundle() or wantedSplit() are.
    void wantedChanged();
    /// What was asked for could not be done: a sentence for the user.
    void failed(const QString& sentence);

  private:
    struct Wanted {
        quint64 id;
        QString address;
        std::optional<nodes::NodeId> node = {};  ///< none: it is not dialled, for ...
        QString problem = {};                    ///< ... this; empty: it will be soon
        bool paused = false;
    };

    void takeBits(const std::vector<std::byte>& bits);
    void dial(Wanted& wanted);
    void dialAll();
    void openPort();
    void beginOrEnd();
    void follow();
    PictureInHand pictureInHand(const Frame& frame) const;
    const nodes::NodeStatus* statusOf(const Wanted& wanted) const;

    RenderBridge& bridge_;
    std::shared_ptr<WorkerPool> pool_;           ///< null: no nodes are wanted
    std::unique_ptr<nodes::RenderNodes> nodes_;  ///< null: likewise, or not yet
    std::vector<std::byte> bits_;                ///< that nodes have to make
    std::vector<Wanted> wanted_;
    std::optional<quint16> port_;
    QString bundle_;
    std::optional<Split> split_;
    quint64 nextId_ = 1;
    NodeFigures figures_;
    NodeEvents events_;
    QList<ui::NodeRow> rows_;
    QElapsedTimer clock_;
};

}  // namespace pdr::app
