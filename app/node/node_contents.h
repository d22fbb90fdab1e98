#pragma once
/// Stores the contents of one coordinator's scenes in a node's memory, never on disk. Assembles contents that arrive;
/// an interrupted transfer is resumed.

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

/// The memory that a scene may take.
struct MemoryLeft {
    std::uint64_t bytes = 0;  ///< bytes that may still be allocated, and that nobody else was promised
    bool hasOthers = false;   ///< whether other coordinators have some of this node's memory
};

class NodeContents {
  public:
    using AskMemory = std::function<MemoryLeft()>;

    /// `key`: that of the coordinator whose contents these are.
    explicit NodeContents(
        const nodes::ContentKey& key, AskMemory memory =
                                          [] {
                                              return MemoryLeft{freeBytes(), false};
                                          })
        : key_(key), memory_(std::move(memory)) {}

    const nodes::ContentKey& key() const { return key_; }

    /// Begins to fetch the contents of `order` that are not here yet. Errors: not enough memory.
    Result<void> order(const wire::SceneOrder& order);
    /// Returns the next request to send; none: all contents are here, or order() has failed.
    std::optional<wire::Need> need() const;
    /// Adds a chunk. Returns whether it completed a content. Errors: the content is damaged and has to be requested
    /// again, or there is not enough memory.
    Result<bool> add(const wire::Chunk& chunk);
    /// Returns the scene of the last order(), once need() returns none. Errors: the contents do not make a scene.
    Result<Scene> scene() const;

    /// Returns the bytes that the last order() was promised, from then on until settle(): some of them are not
    /// allocated yet.
    std::uint64_t promised() const { return promised_; }
    /// Records that the device has loaded the scene, and that no more memory will be taken for it.
    void settle() { promised_ = 0; }

    /// Free memory that a scene needs, as a multiple of the bytes of its missing contents: a content exists twice while
    /// it is made of the bytes that have arrived (2.07 times, measured), and the device derives bounds from it.
    static constexpr double kSceneOverhead = 2.2;

  private:
    using Kept = std::variant<std::shared_ptr<const Volume>, std::shared_ptr<const Mask>,
                              std::shared_ptr<const EnvironmentImage>, std::shared_ptr<const LabelMap>>;
    struct Entry {
        wire::Hash hash;
        Kept content;
    };
    static constexpr std::size_t kMostKept = 5;

    template <class T>
    std::shared_ptr<const T> find(const wire::Hash& hash) const;
    bool isHere(const wire::Hash& hash) const;
    void beginNext();
    Result<void> keep(const wire::ContentAssembly& whole);

    nodes::ContentKey key_;
    AskMemory memory_;
    std::uint64_t promised_ = 0;
    std::optional<wire::SceneOrder> order_;
    std::list<Entry> kept_;  ///< newest first
    std::optional<wire::ContentAssembly> coming_;
};

}  // namespace pdr::node
