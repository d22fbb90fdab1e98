#pragma once
/// Serializes scenes for nodes, each scene once for all nodes. Contents that do not change are hashed once.

#include <map>
#include <memory>

#include "app/coordinator/scene_order.h"
#include "render/tiles/published_scenes.h"

namespace pdr::nodes {

class OutgoingScenes {
  public:
    explicit OutgoingScenes(const ContentKey& key) : key_(key) {}

    /// Returns the serialized scene; null: it cannot be sent, and reason() tells why.
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
    std::map<const void*, Known> known_;  ///< by the address of the content in memory
    std::shared_ptr<const OutgoingScene> last_;
    std::uint64_t lastNumber_ = 0;
    Text reason_;
};

}  // namespace pdr::nodes
