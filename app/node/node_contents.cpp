#include "app/node/node_contents.h"

#include <algorithm>
#include <new>
#include <utility>

#include "render/base/errors.h"

namespace pdr::node {

template <class T>
std::shared_ptr<const T> NodeContents::find(const wire::Hash& hash) const {
    for (const Entry& entry : kept_)
        if (entry.hash == hash)
            if (const auto* found = std::get_if<std::shared_ptr<const T>>(&entry.content))
                return *found;
    return nullptr;
}

bool NodeContents::isHere(const wire::Hash& hash) const {
    return std::ranges::any_of(kept_, [&](const Entry& entry) { return entry.hash == hash; });
}

Result<void> NodeContents::order(const wire::SceneOrder& order) {
    order_ = order;
    promised_ = 0;
    // Drop a volume and labels with the same voxels but another geometry
    const auto liesElsewhere = [&](const VolumeGeometry& geometry) { return !nodes::liesSo(geometry, order.volume); };
    std::erase_if(kept_, [&](const Entry& entry) {
        if (const auto* volume = std::get_if<std::shared_ptr<const Volume>>(&entry.content))
            return entry.hash == order.volume.content && liesElsewhere((*volume)->geometry());
        const auto* labels = std::get_if<std::shared_ptr<const LabelMap>>(&entry.content);
        return labels && order.labels && entry.hash == order.labels->content && liesElsewhere((*labels)->geometry);
    });
    beginNext();
    if (!coming_)
        return {};
    // Check that the missing contents fit into memory
    double missing = 0;
    for (const nodes::WantedContent& wanted : nodes::wantedContents(order))
        if (!isHere(wanted.hash))
            missing += double(wanted.bytes);
    const auto wanted = std::uint64_t(missing * kSceneOverhead);
    const MemoryLeft left = memory_();
    if (wanted <= left.bytes) {
        promised_ = wanted;
        return {};
    }
    coming_.reset();
    const Text bytes = bytesText(std::size_t(missing));
    return notEnoughMemory(left.hasOthers ? phrase("for the scene: %1, since others use this render node, too", bytes)
                                          : phrase("for the scene: %1", bytes),
                           "", "");
}

void NodeContents::beginNext() {
    for (const nodes::WantedContent& wanted : nodes::wantedContents(*order_)) {
        if (isHere(wanted.hash))
            continue;
        if (!coming_ || coming_->content() != wanted.hash) {
            coming_.reset();
            coming_.emplace(key_, wanted.hash, wanted.bytes);
        }
        return;
    }
    coming_.reset();
}

std::optional<wire::Need> NodeContents::need() const {
    if (!coming_)
        return std::nullopt;
    return wire::Need{coming_->content(), coming_->nextChunk()};
}

Result<bool> NodeContents::add(const wire::Chunk& chunk) {
    if (!coming_ || chunk.content != coming_->content() || chunk.index != coming_->nextChunk())
        return false;  // a chunk of a transfer that is over
    if (const Result<void> added = coming_->add(chunk); !added) {
        coming_.reset();
        beginNext();
        return added.error();
    }
    if (!coming_->isWhole())
        return false;
    wire::ContentAssembly whole = *std::exchange(coming_, std::nullopt);
    Result<void> kept = whole.finish();
    if (kept)
        kept = keep(whole);
    beginNext();
    if (!kept)
        return kept.error();
    return true;
}

Result<void> NodeContents::keep(const wire::ContentAssembly& whole) {
    const wire::Hash& hash = whole.content();
    const auto insert = [&](auto content) -> Result<void> {
        if (!content)
            return content.error();
        kept_.push_front({hash, *std::move(content)});
        if (kept_.size() > kMostKept)
            kept_.pop_back();
        return {};
    };
    try {
        if (hash == order_->volume.content)
            return insert(nodes::volumeFrom(order_->volume, whole.bytes()));
        if (order_->mask && hash == order_->mask->content)
            return insert(nodes::maskFrom(*order_->mask, whole.bytes()));
        if (order_->labels && hash == order_->labels->content)
            return insert(nodes::labelsFrom(order_->volume, whole.bytes()));
        return insert(nodes::environmentFrom(*order_->environment, whole.bytes()));
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("for the scene"), "", "");
    }
}

Result<Scene> NodeContents::scene() const {
    nodes::SceneContents contents{find<Volume>(order_->volume.content)};
    if (order_->mask)
        contents.mask = find<Mask>(order_->mask->content);
    if (order_->environment)
        contents.environment = find<EnvironmentImage>(order_->environment->content);
    if (order_->labels)
        contents.labels = find<LabelMap>(order_->labels->content);
    if (!contents.volume || (order_->mask && !contents.mask) || (order_->environment && !contents.environment) ||
        (order_->labels && !contents.labels))
        return Error{phrase("a content of the scene is not what the order says"), "", ""};
    return nodes::sceneFrom(*order_, contents);
}

}  // namespace pdr::node
