#pragma once
/// A scene on its way to a node: an order that names its contents, and the contents themselves. Nothing of a patient
/// but voxels goes into either: no names, remarks, paths or identifiers.

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "app/wire/messages.h"
#include "render/base/result.h"
#include "render/scene/scene.h"

namespace pdr::nodes {

/// Of content hashes, see wire::Welcome.
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

/// Finds the hash of a content, by whatever means.
using HashOf = std::function<wire::Hash(const std::shared_ptr<const void>& owner, std::span<const std::byte> bytes)>;

/// `scene` under that number; it must have passed its check(). Errors: the order would be read as another scene.
Result<OutgoingScene> outgoingScene(std::uint64_t number, const Scene& scene, const HashOf& hashOf);

/// Whether a volume lies as the order says.
bool liesSo(const VolumeGeometry& geometry, const wire::VolumeOrder& order);

/// A content that an order names, and the bytes that it must have.
struct WantedContent {
    wire::Hash hash{};
    std::uint64_t bytes = 0;
};
std::vector<WantedContent> wantedContents(const wire::SceneOrder& order);

/// What a node has of the contents that an order names; what it does not name stays empty.
struct SceneContents {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const EnvironmentImage> environment;
};

/// Each of the bytes that wantedContents() tells. Errors: they cannot be that.
Result<std::shared_ptr<const Volume>> volumeFrom(const wire::VolumeOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const Mask>> maskFrom(const wire::MaskOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const EnvironmentImage>> environmentFrom(const wire::EnvironmentOrder& order,
                                                                std::span<const std::byte> bytes);

/// The scene that was ordered; its revision is the order's number. Errors: the order's text is no such scene.
Result<Scene> sceneFrom(const wire::SceneOrder& order, const SceneContents& contents);

}  // namespace pdr::nodes
