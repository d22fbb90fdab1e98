#pragma once
/// Scenes serialized for nodes, each once for all of them. Contents that do not change are hashed once.

#include <map>
#include <memory>

#include "app/coordinator/scene_order.h"
#include "render/tiles/worker_pool.h"

namespace pdr::nodes {

class OutgoingScenes {
  public:
    explicit OutgoingScenes(const ContentKey& key) : key_(key) {}

    /// Null: it cannot be sent; `reason` says why.
    std::shared_ptr<const OutgoingScene> ready(const PublishedScene& scene);
    const Text& reason() const { return reason_; }
    void forget() { last_.reset(); }

  private:
    wire::Hash hashOf(const std::shared_ptr<const void>& owner, std::span<const std::byte> bytes);

    struct Known {
        std::weak_ptr<const void> owner;
        wire::Hash hash;
    };
    ContentKey key_;
    std::map<const void*, Known> known_;  ///< by the content's place in memory
    std::shared_ptr<const OutgoingScene> last_;
    std::uint64_t lastNumber_ = 0;
    Text reason_;
};

}  // namespace pdr::nodes
