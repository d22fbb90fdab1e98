#pragma once
/// Render nodes of a rendering command: dials the nodes that were named, accepts others, and waits for them.

#include <QStringList>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "app/cli/nodes/node_messages.h"
#include "app/coordinator/render_nodes.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/tiles/worker_pool.h"

namespace pdr::app {

struct NodesWanted {
    QStringList nodes;              ///< addresses of nodes to dial
    std::optional<QString> listen;  ///< address at which nodes may dial this machine; null: none
    QString bundle;                 ///< folder of certificates
    int await = 0;                  ///< number of nodes that must be ready before rendering begins
    int awaitSeconds = 120;         ///< longest wait for these nodes
    bool nodesOnly = false;         ///< true: this machine only checks what the nodes send
    bool checksAll = false;         ///< true: all that nodes send is rendered twice
    std::optional<Split> split;     ///< null: chosen automatically

    bool any() const { return !nodes.isEmpty() || listen.has_value(); }
};

class CommandNodes {
  public:
    /// Connects to the nodes, which must compute the same bits as `device`. Errors: those of addresses, certificates
    /// and the device.
    static Result<std::unique_ptr<CommandNodes>> gather(const NodesWanted& wanted, Device& device);
    /// Returns a device that shares the work of `device` for `scene` with the nodes, if that is worth sending the scene
    /// to them; else `device` itself, and says so. `samples`: the most that a pixel gets; none: not known.
    std::unique_ptr<Device> share(std::unique_ptr<Device> device, const Scene& scene,
                                  std::optional<std::uint64_t> samples);

    /// Waits until as many nodes as requested have the scene of the device, if it is shared. Errors: `stop` was
    /// requested or the time is up first, or too few nodes can still come.
    Result<void> await(const std::stop_token& stop) const;
    /// Returns one line for each node that was named or took part, with what it has done, and a line on how the work
    /// was divided.
    std::string report();
    /// Returns what was checked of the samples of nodes.
    NodeChecks checks() const { return pool_->checks(); }

  private:
    explicit CommandNodes(const NodesWanted& wanted, const std::vector<std::byte>& bits);
    void listenToNews();
    void sayNewsOf(const std::vector<nodes::NodeStatus>& nodes);
    int helpless() const;

    NodesWanted wanted_;
    bool isShared_ = false;  ///< nodes get the scene
    mutable std::mutex mutex_;
    NodeMessages news_;  ///< guarded by mutex_: updated in the network thread
    std::shared_ptr<WorkerPool> pool_;
    nodes::RenderNodes nodes_;
};

}  // namespace pdr::app
