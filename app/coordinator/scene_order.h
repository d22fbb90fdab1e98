#pragma once
/// A scene as it is sent to a node: a SceneOrder, which names contents by hash, and the contents. Neither holds
/// anything about a patient but voxels: no names, remarks, paths or identifiers.

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
    std::shared_ptr<const void> owner;  ///< keeps the bytes alive
    std::span<const std::byte> bytes;
};

struct OutgoingScene {
    wire::SceneOrder order;
    std::vector<Content> contents;
};

/// Returns the hash of a content.
using HashOf = std::function<wire::Hash(const std::shared_ptr<const void>& owner, std::span<const std::byte> bytes)>;

/// Serializes `scene` under that number; it must have passed its check(). Errors: a node would read another scene.
Result<OutgoingScene> outgoingScene(std::uint64_t number, const Scene& scene, const HashOf& hashOf);

/// Whether a volume has the geometry that `order` describes.
bool liesSo(const VolumeGeometry& geometry, const wire::VolumeOrder& order);

/// A content that a SceneOrder names, and its size.
struct WantedContent {
    wire::Hash hash{};
    std::uint64_t bytes = 0;
};
/// Returns all contents that `order` names.
std::vector<WantedContent> wantedContents(const wire::SceneOrder& order);

/// The contents of a SceneOrder, on a node; null where the order names none.
struct SceneContents {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const EnvironmentImage> environment;
    std::shared_ptr<const LabelMap> labels;
};

/// Makes a content from its bytes, as many as wantedContents() returns for it. Errors: the bytes are not such a
/// content.
Result<std::shared_ptr<const Volume>> volumeFrom(const wire::VolumeOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const Mask>> maskFrom(const wire::MaskOrder& order, std::span<const std::byte> bytes);
Result<std::shared_ptr<const EnvironmentImage>> environmentFrom(const wire::EnvironmentOrder& order,
                                                                std::span<const std::byte> bytes);
/// `volume`: the volume whose voxels have the labels. The parts have no names.
Result<std::shared_ptr<const LabelMap>> labelsFrom(const wire::VolumeOrder& volume, std::span<const std::byte> bytes);

/// Returns the requested scene with the revision of `order`. Errors: the text of `order` and the contents are no valid
/// scene.
Result<Scene> sceneFrom(const wire::SceneOrder& order, const SceneContents& contents);

}  // namespace pdr::nodes
