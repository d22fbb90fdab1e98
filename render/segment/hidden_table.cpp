#include "render/segment/hidden_table.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <utility>
#include <vector>

#include "render/base/errors.h"
#include "render/segment/body_mask.h"
#include "render/segment/hidden_slices.h"
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

/// A table that was found, and the cells that are shown without it.
struct FoundTable {
    HiddenTable facts;  ///< without the voxels of the body
    BodyMask mask;      ///< empty where nothing is hidden
};

FoundTable tableIn(const Volume& volume, BodyMask mask, const Checkpoint& checkpoint) {
    HiddenTable table;
    Outside outside = outsideOf(mask, volume, checkpoint);
    if (outside.highest > kMetalHu) {
        table.metalMl = showMetal(volume, mask, checkpoint);
        outside = outsideOf(mask, volume, checkpoint);
    }
    table.bodyBox = boxIn(volume, mask);
    table.outlineMm = placesOf(volume.geometry(), mask.rowEnds);
    table.hiddenMl = double(outside.seen) * voxelMl(volume.geometry());
    table.cutMl = volumeMl(mask.cut, mask.grid);
    table.bodyMl = mask.bodyMl;
    table.parts = mask.parts;
    return {std::move(table), std::move(mask)};
}

FoundTable withoutMemory(const Volume& volume) {
    return {undecided(volume, phrase("there is not enough memory to look for it")), {}};
}

/// Finds the table and its mask, and changes nothing. Error: cancelled().
Result<FoundTable> tableWithMask(const Volume& volume, const Progress& progress) {
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

}  // namespace

bool HiddenTable::hidesAnything() const {
    return undecided.empty() && hiddenMl >= kLeastMl;
}

Result<HiddenTable> findTable(const Volume& volume, const Progress& progress) {
    Result<FoundTable> found = tableWithMask(volume, progress);
    if (!found)
        return found.error();
    return std::move(found->facts);
}

Result<HiddenTable> hideTable(const Volume& volume, const Progress& progress) {
    Result<FoundTable> found = tableWithMask(volume, progress);
    if (!found)
        return found.error();
    try {
        return orCancelled([&]() -> Result<HiddenTable> {
            HiddenTable& table = found->facts;
            if (table.hidesAnything())
                table.body = std::make_shared<const Volume>(volume.withVoxels(
                    hiddenCopy(found->mask, volume, checkpointOf(progress, 0.9, kStep)), factOf(table)));
            checkpointOf(progress, 1, kStep)();
            return std::move(table);
        });
    } catch (const std::bad_alloc&) {
        return withoutMemory(volume).facts;
    }
}

Result<ScanWithoutTable> hideTableIn(Volume scan, const SliceLoss& lost, const Progress& progress) {
    Result<FoundTable> found = tableWithMask(scan, progress);
    if (!found)
        return found.error();
    return orCancelled([&]() -> Result<ScanWithoutTable> {
        HiddenTable& table = found->facts;
        const Checkpoint checkpoint = checkpointOf(progress, 0.9, kStep);
        const auto hide = [&](std::span<std::int16_t> voxels) { hideIn(voxels, found->mask, lost, checkpoint); };
        const bool hides = table.hidesAnything();
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
    if (table.hidesAnything())
        text = joined(text, phrase("Table and holder hidden: %1 outside the body.", volumeText(table.hiddenMl)));
    if (table.hidesAnything() && table.cutMl >= kLeastMl)
        text = joined(text, phrase("%1 of it touched the skin: check the edge.", volumeText(table.cutMl)));
    if (table.hidesAnything() && table.parts > 1)
        text = joined(text, phrase("%1 separate parts are kept.", table.parts));
    if (table.metalMl > 0)
        text = joined(text, phrase("Metal outside the body is kept, with what it touches: %1.",
                                   table.metalMl < kLeastMl ? phrase("less than 1 ml") : volumeText(table.metalMl)));
    return text;
}

}  // namespace pdr::segment
