#pragma once
/// Render nodes of a command that renders: dials those that were named, lets others come, and waits for them.

#include <QStringList>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "app/cli/node_news.h"
#include "app/coordinator/render_nodes.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/tiles/worker_pool.h"

namespace pdr::app {

struct NodesWanted {
    QStringList nodes;              ///< addresses to dial
    std::optional<QString> listen;  ///< where nodes may dial
    QString bundle;                 ///< folder of certificates
    int await = 0;                  ///< so many must be ready before it begins
    int awaitSeconds = 120;         ///< and that so soon
    bool nodesOnly = false;         ///< this machine only checks what they send
    std::optional<Split> split;     ///< none: chosen

    bool any() const { return !nodes.isEmpty() || listen.has_value(); }
};

class NodeCrew {
  public:
    /// `device` shared with them from now on. Errors: addresses, certificates, or the device's.
    static Result<std::unique_ptr<NodeCrew>> gather(const NodesWanted& wanted, std::unique_ptr<Device>& device);

    /// Until as many as are wanted have the scene of the device. Errors: `stop` or the end of the time came first, or
    /// too few can still come.
    Result<void> await(const std::stop_token& stop) const;
    /// One line for each node that was named or took part: what it has done.
    std::string report();

  private:
    explicit NodeCrew(const NodesWanted& wanted, const std::vector<std::byte>& bits);
    void listenToNews();
    void sayNewsOf(const std::vector<nodes::NodeStatus>& nodes);
    int helpless() const;

    NodesWanted wanted_;
    mutable std::mutex mutex_;
    NodeNews news_;  ///< guarded by mutex_: it comes in the network's thread
    std::shared_ptr<WorkerPool> pool_;
    nodes::RenderNodes nodes_;
};

}  // namespace pdr::app
