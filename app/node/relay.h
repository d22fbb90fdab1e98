#pragma once
/// The nodes below a relay. To the coordinator above it a relay is one node; to the nodes that dial it, it is a
/// coordinator: it passes scenes on, shares leases with them, checks their results, and returns the sums.

#include <QTimer>
#include <cstdint>
#include <memory>

#include "app/coordinator/render_nodes.h"
#include "app/coordinator/told_reasons.h"
#include "app/node/node_options.h"
#include "app/node/node_seats.h"
#include "render/tiles/worker_pool.h"

namespace pdr::node {

class Relay : public QObject {
    Q_OBJECT

  public:
    /// `bits`: referenceTiles() of this machine's device, which nodes below must have, too.
    explicit Relay(const std::vector<std::byte>& bits);
    /// Says at last what was checked.
    ~Relay() override;

    /// Waits for nodes at `options.relay`. Errors: certificates, or an address at which this machine cannot listen.
    Result<void> listen(const NodeOptions& options);
    /// Returns what opens devices that share their leases with the nodes below. One of them may have a scene at a time.
    OpenDevice sharing(OpenDevice own) const;
    /// Returns how much of what nodes below have rendered was rendered a second time. The log says so, too.
    NodeChecks checks() const { return pool_->allChecks(); }

  signals:
    /// A line for the log; contains nothing about scenes.
    void said(const QString& line);

  private:
    void tellTroubleOf(const std::vector<nodes::NodeStatus>& nodes);
    void tellChecks();

    std::shared_ptr<WorkerPool> pool_;
    nodes::RenderNodes nodes_;
    nodes::ToldReasons told_;
    QTimer minute_{this};
    std::uint64_t toldResults_ = 0;  ///< results, wrong ones too, of which tellChecks() has spoken
};

}  // namespace pdr::node
