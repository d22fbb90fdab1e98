#pragma once
/// Names, ranges and meanings of the fields of the parts of a patient.

#include <optional>
#include <string>
#include <vector>

#include "render/scene/fields/tissue_fields.h"
#include "render/scene/parts_source.h"

namespace pdr {

/// The material of a part, as files write it.
struct PartMaterialFields {
    int label = 0;
    TransferFunction transferFunction;
    std::optional<float> gradientFactor;
};

template <class Visit>
void describe(Visit& visit, PartMaterialFields& material) {
    visit({"label",
           "number of the part in the label map, as `pdrender-cli parts` lists it",
           {1, double(LabelMap::kMostParts)},
           kRequired},
          material.label);
    visit.object({"transferFunction", "how Hounsfield units become optics in it", {}, kRequired},
                 material.transferFunction);
    visit({"gradientFactor", "how readily its edges reflect; where it is absent, as `surface` says", kGradientFactor},
          material.gradientFactor);
}

/// The parts of a patient, as files write them, where a label map is a path.
struct PartsFields {
    std::optional<std::string> labels;
    std::optional<std::string> find;
    bool resample = false;
    std::vector<PartMaterialFields> materials;
};

template <class Visit>
void describe(Visit& visit, PartsFields& parts) {
    visit({"labels", "the label map: a file, or a folder with a mask of each part"}, parts.labels);
    visit({"find", "or what the program finds in the scan itself, as `--find`: `vessels,shells`"}, parts.find);
    visit({"resample", "whether a label map with other voxels than the scan is taken, each voxel the nearest label"},
          parts.resample);
    visit.list({"materials", "the parts that are not as all other tissue, by ascending `label`"}, parts.materials);
}

}  // namespace pdr
