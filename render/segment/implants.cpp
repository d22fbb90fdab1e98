#include "render/segment/implants.h"

#include <algorithm>
#include <new>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/cell_values.h"
#include "render/segment/distance.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/pieces.h"
#include "render/segment/rule.h"

namespace pdr::segment {
namespace {

constexpr std::string_view kStep = "looking for metal";
constexpr double kLeastMl = 0.05;
constexpr int kEdgeHu = 1500;

Error refused(const Text& why) {
    return {phrase("implants cannot be found, because %1", why), "", "", ErrorKind::refused};
}

Result<LabelMap> implants(const Volume& volume, const BodyMask& body, const Progress& progress) {
    const CellGrid& grid = body.grid;
    const Checkpoint checkpoint = checkpointOf(progress, 0.6, kStep);
    const CellValues values = cellValues(volume, grid, checkpoint);
    Cells metal(grid.count());
    for (std::size_t i = 0; i < metal.size(); ++i)
        metal[i] = body.body[i] && values.highest[i] > kMetalHu;
    metal = piecesWith(metal, kLeastMl / grid.cellMl(), metal, grid, checkpoint);
    if (std::ranges::find(metal, 1) == metal.end())
        return refused(phrase("no metal is in this body"));
    const Cells around = widened(metal, grid, grid.longestMm(), checkpoint);
    LabelMap map;
    map.geometry = volume.geometry();
    map.labels = HugePageVector<std::uint8_t>(volume.voxels().size());
    const ivec3 size = volume.size();
    forEachSlice(size.z, checkpointOf(progress, 0.8, kStep), [&](int z) {
        std::size_t index = std::size_t(z) * std::size_t(size.y) * std::size_t(size.x);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x, ++index)
                map.labels[index] = around[grid.index(x / grid.block.x, y / grid.block.y, z / grid.block.z)] &&
                                    volume.voxels()[index] > kEdgeHu;
    });
    map.parts = {{"implant", {150, 170, 190}}};
    map.source = phrase("a rule of this program");
    map.notes = {
        phrase("implants are guessed by the density of metal: check them; fillings of teeth and undiluted medium "
               "may be among them")};
    return map;
}

}  // namespace

Result<LabelMap> findImplants(const Volume& volume, const Progress& progress) {
    const Result<BodyMask> body = bodyMask(volume, pdr::partOf(progress, 0, 0.5));
    if (!body)
        return body.error().kind == ErrorKind::refused ? refused(body.error().what) : body.error();
    try {
        return orCancelled([&] { return implants(volume, *body, progress); });
    } catch (const std::bad_alloc&) {
        return notEnoughMemoryForVoxels(volume.voxels().size(), "");
    }
}

}  // namespace pdr::segment
