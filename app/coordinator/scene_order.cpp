#include "app/coordinator/scene_order.h"

#include <cstring>
#include <utility>

#include "render/scene/scene_file.h"

namespace pdr::nodes {
namespace {

template <class T>
std::span<const std::byte> bytesOf(const T& values) {
    return std::as_bytes(std::span(values));
}

std::array<double, 12> rowsOf(const dmat4& matrix) {
    std::array<double, 12> rows;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            rows[std::size_t(column) * 3 + std::size_t(row)] = matrix[column][row];
    return rows;
}

dmat4 matrixOf(const std::array<double, 12>& rows) {
    dmat4 matrix(1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            matrix[column][row] = rows[std::size_t(column) * 3 + std::size_t(row)];
    return matrix;
}

/// Source of the voxels in the text of a scene. Scene files name one; here the voxels come with the SceneOrder.
constexpr const char* kWithTheOrder = "with-the-order";

std::string textOf(const Scene& scene) {
    SceneFile file;
    file.scene = scene;
    file.scene.lookName.clear();
    file.source.dicomFolder = kWithTheOrder;
    if (scene.environment.image)
        file.environmentImage = kWithTheOrder;
    if (scene.parts.map)
        file.parts.labels = kWithTheOrder;
    return sceneText(file);
}

/// Resets the field that the camera's projection does not use: scene files do not store it.
void dropUnused(Camera& camera) {
    if (camera.type == Camera::Type::perspective)
        camera.heightMm = Camera().heightMm;
    else
        camera.fovDegrees = Camera().fovDegrees;
}

Scene withoutUnused(Scene scene) {
    dropUnused(scene.camera);
    for (FreehandCut& cut : scene.clip.freehand)
        dropUnused(cut.camera);
    return scene;
}

std::uint64_t voxelsIn(const ivec3& size) {
    return std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
}

Error noContent(const Text& what) {
    return {phrase("the scene that was ordered cannot be rendered: %1", what), "", ""};
}

template <class T>
bool fill(T& values, std::span<const std::byte> bytes) {
    if (bytes.size() != values.size() * sizeof values[0])
        return false;
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return true;
}

}  // namespace

Result<OutgoingScene> outgoingScene(std::uint64_t number, const Scene& scene, const HashOf& hashOf) {
    OutgoingScene going;
    const auto add = [&](const auto& owner, std::span<const std::byte> bytes) {
        going.contents.push_back({hashOf(owner, bytes), owner, bytes});
        return going.contents.back().hash;
    };
    const VolumeGeometry& geometry = scene.volume->geometry();
    going.order.revision = number;
    going.order.volume = {add(scene.volume, bytesOf(scene.volume->voxels())), geometry.size,
                          rowsOf(geometry.patientFromIndex)};
    if (const auto& mask = scene.mask)
        going.order.mask = {add(mask, bytesOf(mask->weights())), mask->grid().voxels, mask->grid().shift};
    if (const auto& image = scene.environment.image)
        going.order.environment = {add(image, bytesOf(image->texels)), image->size};
    if (const auto& map = scene.parts.map)
        going.order.labels = {add(map, bytesOf(map->labels))};
    going.order.text = textOf(scene);

    // Check that a node would read the same scene
    Scene same = scene;
    same.lookName.clear();
    same.revision = number;
    const Result<Scene> read =
        sceneFrom(going.order, {scene.volume, scene.mask, scene.environment.image, scene.parts.map});
    if (!read || withoutUnused(*read) != withoutUnused(same))
        return Error{phrase("this scene cannot be sent to render nodes: they would read another one"), "",
                     phrase("It is rendered on this machine alone.")};
    return going;
}

bool liesSo(const VolumeGeometry& geometry, const wire::VolumeOrder& order) {
    return geometry.size == order.size && rowsOf(geometry.patientFromIndex) == order.patientFromIndex;
}

std::vector<WantedContent> wantedContents(const wire::SceneOrder& order) {
    std::vector<WantedContent> wanted{{order.volume.content, voxelsIn(order.volume.size) * sizeof(std::int16_t)}};
    if (order.mask)
        wanted.push_back({order.mask->content,
                          voxelsIn(MaskGrid{order.mask->voxels, order.mask->shift}.size()) * sizeof(std::int16_t)});
    if (order.environment)
        wanted.push_back({order.environment->content, std::uint64_t(order.environment->size.x) *
                                                          std::uint64_t(order.environment->size.y) * sizeof(vec3)});
    if (order.labels)
        wanted.push_back({order.labels->content, voxelsIn(order.volume.size)});
    return wanted;
}

Result<std::shared_ptr<const Volume>> volumeFrom(const wire::VolumeOrder& order, std::span<const std::byte> bytes) {
    const VolumeGeometry geometry{order.size, matrixOf(order.patientFromIndex)};
    if (const Result<void> spacing = checkSpacing(geometry.spacingMm()); !spacing)
        return spacing.error();
    Voxels voxels(geometry.voxelCount());
    if (!fill(voxels, bytes))
        return noContent(phrase("its volume is of another size"));
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

Result<std::shared_ptr<const Mask>> maskFrom(const wire::MaskOrder& order, std::span<const std::byte> bytes) {
    const MaskGrid grid{order.voxels, order.shift};
    HugePageVector<std::int16_t> weights(voxelsIn(grid.size()));
    if (!fill(weights, bytes))
        return noContent(phrase("its mask is of another size"));
    for (const std::int16_t weight : weights)
        if (weight < 0 || weight > kSeen)
            return noContent(phrase("its mask holds what is no weight"));
    return std::make_shared<const Mask>(grid, std::move(weights), "");
}

Result<std::shared_ptr<const EnvironmentImage>> environmentFrom(const wire::EnvironmentOrder& order,
                                                                std::span<const std::byte> bytes) {
    auto image = std::make_shared<EnvironmentImage>();
    image->size = order.size;
    image->texels.resize(std::size_t(order.size.x) * std::size_t(order.size.y));
    if (!fill(image->texels, bytes))
        return noContent(phrase("its surroundings are of another size"));
    if (const Result<void> checked = image->check(); !checked)
        return checked.error();
    return std::shared_ptr<const EnvironmentImage>(std::move(image));
}

Result<std::shared_ptr<const LabelMap>> labelsFrom(const wire::VolumeOrder& volume, std::span<const std::byte> bytes) {
    auto map = std::make_shared<LabelMap>();
    map->geometry = {volume.size, matrixOf(volume.patientFromIndex)};
    map->labels.resize(map->geometry.voxelCount());
    if (!fill(map->labels, bytes))
        return noContent(phrase("its label map is of another size"));
    return std::shared_ptr<const LabelMap>(std::move(map));
}

Result<Scene> sceneFrom(const wire::SceneOrder& order, const SceneContents& contents) {
    Result<SceneFile> file = sceneFromText(order.text, "the scene that was ordered", "");
    if (!file)
        return file.error();
    Scene scene = std::move(file->scene);
    scene.volume = contents.volume;
    scene.mask = contents.mask;
    scene.environment.image = contents.environment;
    scene.parts.map = contents.labels;
    scene.revision = order.revision;
    if (const Result<void> checked = scene.check(); !checked)
        return checked.error();
    return scene;
}

}  // namespace pdr::nodes
