#include "render/scene/parts.h"

#include <algorithm>
#include <string>

#include "render/scene/fields/ranges.h"
#include "render/scene/range.h"
#include "render/scene/scene.h"

namespace pdr {
namespace {

Result<void> checkMap(const LabelMap& map, const Volume& volume) {
    const VolumeGeometry& grid = volume.geometry();
    if (map.geometry.size != grid.size || map.geometry.patientFromIndex != grid.patientFromIndex ||
        map.labels.size() != grid.voxelCount())
        return Error{phrase("the label map lies on another grid than the volume"), "parts",
                     phrase("Lay it onto the grid of this scan.")};
    return {};
}

Result<void> checkCurves(const std::vector<PartCurve>& curves) {
    int last = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const std::string where = "parts[" + std::to_string(i) + "]";
        if (curves[i].label <= last)
            return Error{phrase("labels must ascend from 1 on"), where + ".label", ""};
        last = curves[i].label;
        if (const Result<void> checked = curves[i].transferFunction.check(); !checked)
            return below(where, checked.error());
        if (Result<void> checked =
                checkRange(curves[i].gradientFactor.value_or(0), kGradientFactor, where + ".gradientFactor");
            !checked)
            return checked;
    }
    return {};
}

}  // namespace

float highestGradientFactor(const Scene& scene) {
    float highest = scene.gradientFactor;
    if (!scene.parts.map)
        return highest;
    for (const PartCurve& part : scene.parts.curves)
        highest = std::max(highest, part.gradientFactor.value_or(0));
    return highest;
}

Result<void> checkParts(const Scene& scene) {
    const Parts& parts = scene.parts;
    if (!parts.map && parts.curves.empty())
        return {};
    if (scene.model == Model::emission || scene.model == Model::emissionAbsorption)
        return Error{phrase("the model %1 knows no materials of parts", std::string(modelName(scene.model))), "parts",
                     phrase("Take absorption, singleScattering or multipleScattering, or leave the parts out.")};
    if (parts.map && scene.volume)
        if (Result<void> checked = checkMap(*parts.map, *scene.volume); !checked)
            return checked;
    return checkCurves(parts.curves);
}

}  // namespace pdr
