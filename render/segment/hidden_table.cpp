#include "render/segment/hidden_table.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <utility>
#include <vector>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/for_each_slice.h"
#include "render/segment/outside_metal.h"
#include "render/segment/rule.h"
#include "render/volume/sheared.h"

namespace pdr::segment {
namespace {

constexpr double kLeastMl = 1;
constexpr std::string_view kStep = "hiding the table";

/// Returns "884 ml", from 10 l on "16.8 l".
Text volumeText(double ml) {
    return ml < 9999.5 ? phrase("%1 ml", fixedNumber(ml, 0)) : phrase("%1 l", fixedNumber(ml / 1000, 1));
}

HiddenTable undecided(const Volume& volume, const Text& why) {
    HiddenTable table;
    table.bodyBox = volume.geometry();
    table.undecided = why;
    return table;
}

/// The changes to one slice of voxels.
struct HiddenSlice {
    std::int64_t seen = 0;  ///< voxels denser than kSeenHu that were replaced by air
    std::int16_t highest = INT16_MIN;
};

/// Replaces with air the voxels of slice `z` that lie in cells which are not shown.
HiddenSlice hideSlice(const BodyMask& mask, ivec3 size, int z, std::int16_t* slice) {
    HiddenSlice hidden;
    for (int y = 0; y < size.y; ++y) {
        const std::uint8_t* shown = &mask.shown[mask.grid.index(0, y / mask.grid.block.y, z / mask.grid.block.z)];
        std::int16_t* row = slice + std::size_t(y) * std::size_t(size.x);
        for (int x = 0; x < size.x; ++x) {
            if (shown[x / mask.grid.block.x])
                continue;
            hidden.seen += row[x] > kSeenHu;
            hidden.highest = std::max(hidden.highest, row[x]);
            row[x] = Volume::kAirHu;
        }
    }
    return hidden;
}

VolumeGeometry boxIn(const Volume& volume, const BodyMask& mask) {
    const ivec3 first = mask.box.first * mask.grid.block;
    return volume.geometry().part(first, glm::min(mask.box.end * mask.grid.block, volume.size()) - first);
}

std::shared_ptr<const std::vector<dvec3>> placesOf(const VolumeGeometry& geometry, std::vector<dvec3> indices) {
    for (dvec3& place : indices)
        place = dvec3(geometry.patientFromIndex * dvec4(place, 1.0));
    return std::make_shared<const std::vector<dvec3>>(std::move(indices));
}

/// Returns the statement in image files: the hidden volume, and the rule.
std::string factOf(const HiddenTable& table) {
    char rule[80];
    std::snprintf(rule, sizeof rule, ", rule %d, %d HU, %g mm, %g mm", kRule, kSolidHu, kOpeningMm, kBallMm);
    return volumeText(table.hiddenMl) + " of " + volumeText(table.hiddenMl + table.bodyMl) + rule;
}

/// A copy of the scan's voxels with air outside a mask.
struct Masked {
    Voxels voxels;
    HiddenSlice hidden;  ///< changes to all slices
};

Masked masked(const Volume& volume, const BodyMask& mask, const Checkpoint& checkpoint) {
    const ivec3 size = volume.size();
    const std::size_t area = std::size_t(size.x) * std::size_t(size.y);
    Masked result{Voxels(volume.voxels().begin(), volume.voxels().end()), {}};
    std::vector<HiddenSlice> slices(std::size_t(size.z));
    forEachSlice(size.z, checkpoint, [&](int z) {
        slices[std::size_t(z)] = hideSlice(mask, size, z, result.voxels.data() + area * std::size_t(z));
    });
    for (const HiddenSlice& slice : slices)
        result.hidden = {result.hidden.seen + slice.seen, std::max(result.hidden.highest, slice.highest)};
    return result;
}

HiddenTable tableOf(const Volume& volume, BodyMask mask, const Checkpoint& checkpoint) {
    HiddenTable table;
    Masked all = masked(volume, mask, checkpoint);
    if (all.hidden.highest > kMetalHu) {
        all.voxels = {};  // frees the first copy before the second is made
        table.metalMl = showMetal(volume, mask);
        all = masked(volume, mask, checkpoint);
    }
    table.bodyBox = boxIn(volume, mask);
    table.outlineMm = placesOf(volume.geometry(), mask.rowEnds);
    table.hiddenMl = double(all.hidden.seen) * voxelMl(volume.geometry());
    table.cutMl = volumeMl(mask.cut, mask.grid);
    table.bodyMl = mask.bodyMl;
    table.parts = mask.parts;
    if (table.hiddenMl >= kLeastMl)
        table.body = std::make_shared<const Volume>(volume.withVoxels(std::move(all.voxels), factOf(table)));
    return table;
}

}  // namespace

Result<HiddenTable> hideTable(const Volume& volume, const Progress& progress) {
    try {
        Result<BodyMask> mask = bodyMask(volume, partOf(progress, 0, 0.7));
        if (!mask && mask.error().kind == ErrorKind::cancelled)
            return mask.error();
        return orCancelled([&]() -> Result<HiddenTable> {
            HiddenTable table = mask ? tableOf(volume, *std::move(mask), checkpointOf(progress, 0.8, kStep))
                                     : undecided(volume, mask.error().what);
            checkpointOf(progress, 1, kStep)();
            return table;
        });
    } catch (const std::bad_alloc&) {
        return undecided(volume, phrase("there is not enough memory to look for it"));
    }
}

Text tableText(const HiddenTable& table) {
    Text text;
    if (!table.undecided.empty())
        text = joined(text, phrase("No table was hidden, because %1.", table.undecided));
    if (table.body)
        text = joined(text, phrase("Table and holder hidden: %1 outside the body.", volumeText(table.hiddenMl)));
    if (table.body && table.cutMl >= kLeastMl)
        text = joined(text, phrase("%1 of it touched the skin: check the edge.", volumeText(table.cutMl)));
    if (table.body && table.parts > 1)
        text = joined(text, phrase("%1 separate parts are kept.", table.parts));
    if (table.metalMl > 0)
        text = joined(text, phrase("Metal outside the body is kept, with what it touches: %1.",
                                   table.metalMl < kLeastMl ? phrase("less than 1 ml") : volumeText(table.metalMl)));
    return text;
}

}  // namespace pdr::segment
