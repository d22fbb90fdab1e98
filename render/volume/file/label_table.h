#pragma once
/// The names and colours that volume files keep of their labels.
///   NRRD   the pairs SegmentN_LabelValue, SegmentN_Name and SegmentN_Color that 3D Slicer writes
///   NIfTI  the extension with a LabelTable (Caret's XML), which TotalSegmentator and Connectome Workbench write

#include <map>
#include <optional>
#include <string>

#include "render/base/result.h"
#include "render/volume/file/grid_file.h"
#include "render/volume/label_map.h"

namespace pdr {

/// What a file says of a label; what is absent it does not say.
struct StatedPart {
    std::string name;
    std::optional<LabelColour> colour;
};

/// The parts by their values.
using LabelTable = std::map<std::int64_t, StatedPart>;

/// Returns the table of `grid`; empty if it has none, or none that can be read.
LabelTable labelTable(const GridFile& grid);

/// Returns the table in Caret's XML: <Label Key="5" Red="1" Green="0.5" Blue="0"><![CDATA[liver]]></Label>.
LabelTable caretLabels(std::string_view xml);

}  // namespace pdr
