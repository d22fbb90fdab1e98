#pragma once
/// A scene as it travels to a node: an order that names contents by hash, and the contents. Of a patient neither holds
/// anything but voxels: no names, remarks, paths or identifiers.

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "app/wire/messages.h"
#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::nodes {

/// Key of content hashes, see wire::Welcome.
using ContentKey = std::array<std::byte, 32>;

struct Content {
    wire::Hash hash{};
    std::shared_ptr<const void> owner;  ///< of the bytes
    std::span<const std::byte> bytes;
};

struct OutgoingScene {
    wire::SceneOrder order;
    std::vector<Content> contents;
};

/// Returns the hash of a content.
using HashOf = std::function<wire::Hash(const std::shared_ptr<const void>& owner, std::span<const std::byte> bytes)>;

/// `scene` under that number; it must have passed its check(). Errors: the order would be read as another scene.
Result<OutgoingScene> outgoingScene(std::uint64_t number, const Scene& scene, const HashOf& hashOf);

/// Whether a volume has the geometry of the order.
bool liesSo(const VolumeGeometry& geometry, const wire::VolumeOrder& order);

/// A content that an order names, and its size.
struct WantedContent {
    wire::Hash hash{};
    std::uint64_t bytes = 0;
};
std::vector<WantedContent> wantedContents(const wire::SceneOrder& order);

/// The contents of an order, on a node; empty where the order names none.
struct SceneContents {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const EnvironmentImage> environment;
};

/// From as many bytes as wantedContents() tells. Errors: the bytes are not such a content.
Result<std::shared_ptr<const Volume>> volumeFrom(const wire::VolumeOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const Mask>> maskFrom(const wire::MaskOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const EnvironmentImage>> environmentFrom(const wire::EnvironmentOrder& order,
                                                                std::span<const std::byte> bytes);

/// The scene that was ordered; its revision is the order's number. Errors: the order's text is no such scene.
Result<Scene> sceneFrom(const wire::SceneOrder& order, const SceneContents& contents);

}  // namespace pdr::nodes
