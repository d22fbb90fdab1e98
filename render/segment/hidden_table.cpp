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

/// What lies in one slice outside the cells that are shown.
struct HiddenSlice {
    std::int64_t seen = 0;  ///< voxels denser than kSeenHu
    std::int16_t highest = INT16_MIN;
};

/// Calls visit(y, hidden) for each row of slice `z`: a voxel whose number in `hidden` is -1 is not shown; 0: it is.
/// Numbers of the voxels' own width let the visits become vector instructions.
template <class Visit>
void forEachRow(const BodyMask& mask, int z, Visit visit) {
    const CellGrid& grid = mask.grid;
    std::vector<std::int16_t> hidden(std::size_t(grid.voxels.x));
    for (int y = 0; y < grid.voxels.y; ++y) {
        if (y % grid.block.y == 0) {
            const std::uint8_t* shown = &mask.shown[grid.index(0, y / grid.block.y, z / grid.block.z)];
            for (int x = 0; x < grid.voxels.x; x += grid.block.x, ++shown)
                std::fill_n(hidden.begin() + x, std::min(grid.block.x, grid.voxels.x - x),
                            std::int16_t(*shown ? 0 : -1));
        }
        visit(y, hidden.data());
    }
}

HiddenSlice hiddenIn(const BodyMask& mask, int z, const std::int16_t* slice) {
    HiddenSlice all;
    const int length = mask.grid.voxels.x;
    forEachRow(mask, z, [&](int y, const std::int16_t* hidden) {
        const std::int16_t* row = slice + std::size_t(y) * std::size_t(length);
        int seen = 0;
        std::int16_t highest = INT16_MIN;
        for (int x = 0; x < length; ++x) {
            seen += hidden[x] & int(row[x] > kSeenHu);
            highest = std::max(highest, std::int16_t((row[x] & hidden[x]) | (INT16_MIN & ~hidden[x])));
        }
        all = {all.seen + seen, std::max(all.highest, highest)};
    });
    return all;
}

/// Replaces the voxels of slice `z` that are not shown with air.
void hideSlice(const BodyMask& mask, int z, std::int16_t* slice) {
    const int length = mask.grid.voxels.x;
    forEachRow(mask, z, [&](int y, const std::int16_t* hidden) {
        std::int16_t* row = slice + std::size_t(y) * std::size_t(length);
        for (int x = 0; x < length; ++x)
            row[x] = std::int16_t((row[x] & ~hidden[x]) | (Volume::kAirHu & hidden[x]));
    });
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

/// Returns the number of voxels in a slice.
std::size_t sliceVoxels(ivec3 size) {
    return std::size_t(size.x) * std::size_t(size.y);
}

HiddenSlice hiddenIn(const BodyMask& mask, const Volume& volume, const Checkpoint& checkpoint) {
    const ivec3 size = volume.size();
    std::vector<HiddenSlice> slices(std::size_t(size.z));
    forEachSlice(size.z, checkpoint, [&](int z) {
        slices[std::size_t(z)] = hiddenIn(mask, z, &volume.voxels()[sliceVoxels(size) * std::size_t(z)]);
    });
    HiddenSlice all;
    for (const HiddenSlice& slice : slices)
        all = {all.seen + slice.seen, std::max(all.highest, slice.highest)};
    return all;
}

/// A table that was found, and the cells that are shown without it.
struct FoundTable {
    HiddenTable facts;  ///< without the voxels of the body
    BodyMask mask;      ///< empty where nothing is hidden

    bool hidesAnything() const { return facts.undecided.empty() && facts.hiddenMl >= kLeastMl; }
};

FoundTable tableIn(const Volume& volume, BodyMask mask, const Checkpoint& checkpoint) {
    HiddenTable table;
    HiddenSlice hidden = hiddenIn(mask, volume, checkpoint);
    if (hidden.highest > kMetalHu) {
        table.metalMl = showMetal(volume, mask);
        hidden = hiddenIn(mask, volume, checkpoint);
    }
    table.bodyBox = boxIn(volume, mask);
    table.outlineMm = placesOf(volume.geometry(), mask.rowEnds);
    table.hiddenMl = double(hidden.seen) * voxelMl(volume.geometry());
    table.cutMl = volumeMl(mask.cut, mask.grid);
    table.bodyMl = mask.bodyMl;
    table.parts = mask.parts;
    return {std::move(table), std::move(mask)};
}

FoundTable withoutMemory(const Volume& volume) {
    return {undecided(volume, phrase("there is not enough memory to look for it")), {}};
}

/// Finds the table, and changes nothing. Error: cancelled().
Result<FoundTable> findTable(const Volume& volume, const Progress& progress) {
    try {
        Result<BodyMask> mask = bodyMask(volume, partOf(progress, 0, 0.7));
        if (!mask && mask.error().kind == ErrorKind::cancelled)
            return mask.error();
        return orCancelled([&]() -> Result<FoundTable> {
            if (!mask)
                return FoundTable{undecided(volume, mask.error().what), {}};
            return tableIn(volume, *std::move(mask), checkpointOf(progress, 0.8, kStep));
        });
    } catch (const std::bad_alloc&) {
        return withoutMemory(volume);
    }
}

/// Returns a copy of the voxels with air in place of the table.
Voxels hiddenCopy(const Volume& volume, const BodyMask& mask, const Checkpoint& checkpoint) {
    const std::size_t count = sliceVoxels(volume.size());
    Voxels voxels(volume.voxels().size());
    forEachSlice(volume.size().z, checkpoint, [&](int z) {
        const std::size_t first = count * std::size_t(z);
        std::copy_n(&volume.voxels()[first], count, &voxels[first]);
        hideSlice(mask, z, &voxels[first]);
    });
    return voxels;
}

/// Replaces the table with air in `voxels`, and calls `lost` for the slices that change.
void hideIn(std::span<std::int16_t> voxels, const BodyMask& mask, const SliceLoss& lost, const Checkpoint& checkpoint) {
    const std::size_t count = sliceVoxels(mask.grid.voxels);
    forEachSlice(mask.grid.voxels.z, checkpoint, [&](int z) {
        const std::span<std::int16_t> slice = voxels.subspan(count * std::size_t(z), count);
        const std::vector<std::int16_t> before(slice.begin(), slice.end());
        hideSlice(mask, z, slice.data());
        if (!std::ranges::equal(before, slice))
            lost(z, before, slice);
    });
}

}  // namespace

Result<HiddenTable> hideTable(const Volume& volume, const Progress& progress) {
    Result<FoundTable> found = findTable(volume, progress);
    if (!found)
        return found.error();
    try {
        return orCancelled([&]() -> Result<HiddenTable> {
            HiddenTable& table = found->facts;
            if (found->hidesAnything())
                table.body = std::make_shared<const Volume>(volume.withVoxels(
                    hiddenCopy(volume, found->mask, checkpointOf(progress, 0.9, kStep)), factOf(table)));
            checkpointOf(progress, 1, kStep)();
            return std::move(table);
        });
    } catch (const std::bad_alloc&) {
        return withoutMemory(volume).facts;
    }
}

Result<ScanWithoutTable> hideTableIn(Volume scan, const SliceLoss& lost, const Progress& progress) {
    Result<FoundTable> found = findTable(scan, progress);
    if (!found)
        return found.error();
    return orCancelled([&]() -> Result<ScanWithoutTable> {
        HiddenTable& table = found->facts;
        const Checkpoint checkpoint = checkpointOf(progress, 0.9, kStep);
        const auto hide = [&](std::span<std::int16_t> voxels) { hideIn(voxels, found->mask, lost, checkpoint); };
        const bool hides = found->hidesAnything();
        const auto seen =
            std::make_shared<const Volume>(hides ? std::move(scan).changed(hide, factOf(table)) : std::move(scan));
        if (hides)
            table.body = seen;
        checkpointOf(progress, 1, kStep)();
        return ScanWithoutTable{seen, std::move(table)};
    });
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
