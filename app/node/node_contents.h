#pragma once
/// Contents of scenes, in a node's memory only. Assembles the ones that arrive; an interrupted transfer is resumed.

#include <list>
#include <optional>
#include <variant>

#include "app/nodes/scene_order.h"
#include "app/wire/content.h"

namespace pdr::node {

class NodeContents {
  public:
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

    std::optional<nodes::ContentKey> key_;
    std::optional<wire::SceneOrder> order_;
    std::list<Entry> kept_;  ///< the newest first
    std::optional<wire::ContentAssembly> coming_;
};

}  // namespace pdr::node
