#pragma once
/// Contents of scenes in a node's memory, and only there. Those that come are put together here, so that a transfer
/// that was cut off goes on where it was.

#include <list>
#include <optional>
#include <variant>

#include "app/nodes/scene_order.h"
#include "app/wire/content.h"

namespace pdr::node {

class NodeContents {
  public:
    /// The coordinator whose contents come from now on. Those of another one are forgotten.
    void setKey(const nodes::ContentKey& key);

    /// Begins with what is missing for `order`. Errors: there is not enough memory.
    Result<void> order(const wire::SceneOrder& order);
    /// What is to be asked for next; none: all is there.
    std::optional<wire::Need> need() const;
    /// True: it was the last one of a content. Errors: it is damaged; the content is to be asked for again.
    Result<bool> add(const wire::Chunk& chunk);
    /// The scene that was ordered last, when need() is none. Errors: it cannot be made of the contents.
    Result<Scene> scene() const;

    void forget();
    /// Scans are here, whole or in part.
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
