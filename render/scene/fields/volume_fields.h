#pragma once
/// Names, ranges and meanings of the fields of the volume.

#include <optional>
#include <string>
#include <utility>

#include "render/scene/fields/ranges.h"
#include "render/scene/scene_file.h"

namespace pdr {

inline constexpr Words<RawFile::Type, 4> kVoxelWords{{{"int16", RawFile::Type::int16},
                                                      {"uint16", RawFile::Type::uint16},
                                                      {"uint8", RawFile::Type::uint8},
                                                      {"float32", RawFile::Type::float32}}};
inline constexpr Words<Reconstruction, 2> kReconstructionWords{
    {{"linear", Reconstruction::linear}, {"cubic", Reconstruction::cubic}}};

inline constexpr Words<Table, 2> kTableWords{{{"shown", Table::shown}, {"hidden", Table::hidden}}};

/// The origin of the voxels, as files write it.
struct VolumeFields {
    std::optional<std::string> dicom, series, raw;
    RawFile file;  ///< its path is `raw`
    std::optional<std::pair<int, int>> clampHu;
    Table table = Table::shown;
    Reconstruction reconstruction = Reconstruction::linear;
};

template <class Visit>
void describe(Visit& visit, VolumeFields& volume) {
    visit({"dicom", "the folder of DICOM files, or a scan in one file"}, volume.dicom);
    visit({"raw", "or the raw file"}, volume.raw);
    if (Visit::kBranches || volume.dicom)
        visit({"series",
               "SeriesInstanceUID of the series to take, as `info` names it (`#2` behind it: its second "
               "part); where it is absent, the first that can be loaded"},
              volume.series);
    if (Visit::kBranches || volume.raw || !volume.dicom) {
        visit({"size", "voxels along x, y, z", {1, 65536}, kRequired}, volume.file.size);
        visit({"spacingMm", "distance of voxel centres [mm]", {kLowestSpacingMm, kHighestSpacingMm}, kRequired},
              volume.file.spacingMm);
        visit.word({"type", "of a voxel; float32 is rounded"}, volume.file.type, kVoxelWords);
        visit({"originMm",
               "centre of voxel (0, 0, 0); where it is absent, half a spacing, so that the box begins at 0 "
               "[mm]",
               kPlaceMm},
              volume.file.originMm);
    }
    visit({"clampHu", "`[lowest, highest]`: every voxel is clamped to this interval first [HU]", kHounsfield},
          volume.clampHu);
    visit.word(
        {"table",
         "`hidden`: all outside the patient's body is air, as far as it is known what is body: table, head holder, "
         "clothes. The voxels themselves stay as they are; images say how much is hidden. `pdrender-cli render "
         "--table` goes before it"},
        volume.table, kTableWords);
    visit.word(
        {"reconstruction",
         "what stands between the slices: `linear` goes evenly from one to the next, `cubic` first puts one more "
         "between each two, from the four around it. Steps of the slices are lower then, by half where slopes "
         "are gentle; it takes twice the memory, and images say `slices interpolated`"},
        volume.reconstruction, kReconstructionWords);
}

}  // namespace pdr
