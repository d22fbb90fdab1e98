#include "app/coordinator/outgoing_scenes.h"

#include "app/wire/content_hash.h"

namespace pdr::nodes {

std::shared_ptr<const OutgoingScene> OutgoingScenes::ready(const PublishedScene& scene) {
    if (lastNumber_ == scene.number)
        return last_;
    lastNumber_ = scene.number;
    const auto find = [this](const auto& owner, std::span<const std::byte> bytes) { return hashOf(owner, bytes); };
    Result<OutgoingScene> going = outgoingScene(scene.number, *scene.scene, find);
    reason_ = going ? Text() : going.error().text();
    last_ = going ? std::make_shared<const OutgoingScene>(*std::move(going)) : nullptr;
    return last_;
}

wire::Hash OutgoingScenes::hashOf(const std::shared_ptr<const void>& owner, std::span<const std::byte> bytes) {
    std::erase_if(known_, [](const auto& one) { return one.second.owner.expired(); });
    const auto known = known_.find(bytes.data());
    if (known != known_.end())
        return known->second.hash;
    const wire::Hash hash = wire::contentHash(key_, bytes);
    known_[bytes.data()] = {owner, hash};
    return hash;
}

}  // namespace pdr::nodes
