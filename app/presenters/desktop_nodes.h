#pragma once
/// The render nodes of the window: those requested by the user, now or in an earlier run, and those that dial in. While
/// none are requested they cost nothing; with the first one, the device that renders the image shares its work with
/// them. The destructor says goodbye to all nodes, which then erase their data.

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/coordinator/render_nodes.h"
#include "app/presenters/node_events.h"
#include "app/presenters/node_figures.h"
#include "app/rendering/render_bridge.h"

namespace pdr::app {

class DesktopNodes : public QObject {
    Q_OBJECT

  public:
    /// `bridge` must outlive this object.
    explicit DesktopNodes(RenderBridge& bridge);
    ~DesktopNodes() override;

    /// The nodes as of the last change, requested ones first.
    const QList<ui::NodeRow>& rows() const { return rows_; }
    const ui::PlotEvents& events() const { return events_.events(); }
    QStringList addresses() const;  ///< addresses of the requested nodes
    std::optional<quint16> port() const { return port_; }
    const QString& bundle() const { return bundle_; }
    std::optional<Split> wantedSplit() const { return split_; }
    bool checksAll() const { return checksAll_; }
    /// Returns how the work is split between nodes, and why; empty without work or without nodes that can take it.
    QString splitText() const;
    /// Returns how much of what nodes sent for this image was checked, and what that would have found; empty if they
    /// sent nothing.
    QString checksText() const;

  public slots:
    /// Requests a node, which is dialled from now on.
    void add(const QString& address);
    void remove(quint64 id);
    void setPaused(quint64 id, bool paused);
    /// Lets nodes dial in to `port`; none: no node may.
    void listen(const std::optional<quint16>& port);
    /// Sets the folder of this machine's certificates for all connections from now on; empty: there are none. Requested
    /// nodes are dialled anew, and the port is opened anew.
    void setBundle(const QString& folder);
    /// Sets how the work is split; none: by its costs.
    void setSplit(const std::optional<pdr::Split>& split);
    /// Sets whether all that nodes send is rendered twice, before it is used.
    void setChecksAll(bool all);

  signals:
    /// Emitted when rows() or events() may have changed: when a node changes, and with each frame while there are
    /// nodes.
    void changed();
    /// Emitted when addresses(), port(), bundle(), wantedSplit() or checksAll() have changed.
    void wantedChanged();
    /// Emitted when a request failed, with a sentence for the user.
    void failed(const QString& sentence);

  private:
    struct Wanted {
        quint64 id;
        QString address;
        std::optional<nodes::NodeId> node = {};  ///< none: it is not dialled
        QString problem = {};                    ///< why it cannot be dialled; empty: it is dialled, or will be soon
        bool paused = false;
    };

    void takeBits(const std::vector<std::byte>& bits);
    void dial(Wanted& wanted);
    void dialAll();
    void openPort();
    void beginOrEnd();
    void follow();
    ImageInHand imageInHand(const Frame& frame) const;
    const nodes::NodeStatus* statusOf(const Wanted& wanted) const;

    RenderBridge& bridge_;
    std::shared_ptr<WorkerPool> pool_;           ///< null: neither nodes nor a port are requested
    std::unique_ptr<nodes::RenderNodes> nodes_;  ///< null: there is no pool, or its device is not shared yet
    std::vector<std::byte> bits_;                ///< reference tiles, which nodes must reproduce bit by bit
    std::vector<Wanted> wanted_;
    std::optional<quint16> port_;
    QString bundle_;
    std::optional<Split> split_;
    bool checksAll_ = false;
    quint64 nextId_ = 1;
    NodeFigures figures_;
    NodeEvents events_;
    QList<ui::NodeRow> rows_;
    QElapsedTimer clock_;
};

}  // namespace pdr::app
