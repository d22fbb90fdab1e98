#pragma once
/// Contents of scenes, in a node's memory only. Assembles the ones that arrive; an interrupted transfer is resumed.

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <utility>
#include <variant>

#include "app/coordinator/scene_order.h"
#include "app/wire/content.h"
#include "render/base/free_memory.h"

namespace pdr::node {

class NodeContents {
  public:
    /// `freeMemory`: bytes that may still be taken.
    explicit NodeContents(std::function<std::uint64_t()> freeMemory = freeBytes) : freeMemory_(std::move(freeMemory)) {}

    /// Sets the coordinator whose contents come from now on; erases those of another one.
    void setKey(const nodes::ContentKey& key);

    /// Begins to fetch what `order` lacks. Errors: not enough memory.
    Result<void> order(const wire::SceneOrder& order);
    /// The next request to send; none: all contents are here.
    std::optional<wire::Need> need() const;
    /// True: it completed a content. Errors: it is damaged; the content has to be requested again.
    Result<bool> add(const wire::Chunk& chunk);
    /// The scene of the last order, once need() is none. Errors: it cannot be made of the contents.
    Result<Scene> scene() const;

    void forget();
    /// No content is here, whole or in part.
    bool empty() const { return kept_.empty() && !coming_; }

    /// Memory that a scene is refused without, over the bytes of its contents: while one is made of what has arrived,
    /// it is there twice (2.07 times, measured), and the device derives bounds of it.
    static constexpr double kSceneOverhead = 2.2;

  private:
    using Kept = std::variant<std::shared_ptr<const Volume>, std::shared_ptr<const Mask>,
                              std::shared_ptr<const EnvironmentImage>>;
    struct Entry {
        wire::Hash hash;
        Kept content;
    };
    static constexpr std::size_t kMostKept = 4;

    template <class T>
    std::shared_ptr<const T> find(const wire::Hash& hash) const;
    bool isHere(const wire::Hash& hash) const;
    void beginNext();
    Result<void> keep(const wire::ContentAssembly& whole);

    std::function<std::uint64_t()> freeMemory_;
    std::optional<nodes::ContentKey> key_;
    std::optional<wire::SceneOrder> order_;
    std::list<Entry> kept_;  ///< the newest first
    std::optional<wire::ContentAssembly> coming_;
};

}  // namespace pdr::node
