#pragma once
/// A label map: which part of the patient each voxel of a grid belongs to, if any, and the names of the parts. Other
/// programs segment a scan and write one (volume/file/label_file.h); rules find some parts themselves (segment/).
///   labels  x fastest, then y, then z, as in a Volume; 0: in no part, n: in parts[n - 1]

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/base/huge_pages.h"
#include "render/base/text.h"
#include "render/volume/volume.h"

namespace pdr {

/// A colour as screens and files have it: sRGB, 8 bits a channel.
using LabelColour = std::array<std::uint8_t, 3>;

/// A part of the patient that a label map marks.
struct MappedPart {
    std::string name;  ///< as its source has it ("liver"), UTF-8; two parts may have one name
    LabelColour colour{};

    bool operator==(const MappedPart&) const = default;
};

struct LabelMap {
    static constexpr std::size_t kMostParts = 255;

    VolumeGeometry geometry;  ///< the grid of the labels, which may be another than that of the scan
    HugePageVector<std::uint8_t> labels;
    std::vector<MappedPart> parts;
    Text source;              ///< who says so, within a sentence: "a NIfTI file"
    std::vector<Text> notes;  ///< what the user should know of it, in phrases
};

/// Returns the volume of each part by whole voxels [ml].
std::vector<double> partsMl(const LabelMap& map);

/// Returns the note that so many parts have a name and no voxels.
Text emptyPartsNote(std::int64_t count);

/// Returns the name of a part that has none, by its number in the source.
std::string standardName(std::int64_t number);
/// Returns the colour of a part that has none: neighbouring numbers differ clearly.
LabelColour standardColour(std::int64_t number);

/// Two parts that are named alike but for their side, and lie the wrong way round.
struct CrossedSides {
    std::string left, right;  ///< the names
};
/// Returns a pair of parts of which the one named "left" lies at the patient's right of the one named "right", by
/// more than 10 mm from centre to centre; none if no pair does, or as many pairs lie as they should.
std::optional<CrossedSides> crossedSides(const LabelMap& map);

}  // namespace pdr
