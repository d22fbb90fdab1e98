#pragma once
/// Render nodes of a command that renders: dials those that were named, lets others come, and waits for them.

#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/nodes/render_nodes.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/tiles/worker_pool.h"

namespace pdr::app {

struct NodesWanted {
    QStringList nodes;              ///< addresses to dial
    std::optional<QString> listen;  ///< where nodes may dial
    QString bundle;                 ///< folder of certificates
    int await = 0;                  ///< so many must be ready before it begins
    bool nodesOnly = false;         ///< this machine only checks what they send
    std::optional<Split> split;     ///< none: chosen

    bool any() const { return !nodes.isEmpty() || listen.has_value(); }
};

class NodeCrew {
  public:
    /// `device` shared with them from now on. Errors: addresses, certificates, or the device's.
    static Result<std::unique_ptr<NodeCrew>> gather(const NodesWanted& wanted, std::unique_ptr<Device>& device);

    /// Until as many as are wanted have the scene of the device; false: `stop` came first.
    bool await(const std::stop_token& stop) const;
    /// One line for each node: what it has done.
    std::string report() const;

  private:
    explicit NodeCrew(const NodesWanted& wanted, const std::vector<std::byte>& bits);

    NodesWanted wanted_;
    std::shared_ptr<WorkerPool> pool_;
    nodes::RenderNodes nodes_;
};

}  // namespace pdr::app
