#pragma once
/// Parts of the patient with materials of their own: a curve with its colours for each label of a label map, where one
/// curve over HU cannot tell blood with contrast medium from bone.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/scene/transfer_function.h"
#include "render/volume/label_map.h"

namespace pdr {

/// The curve of the voxels of one label, and their surfaces.
struct PartCurve {
    std::uint8_t label = 0;  ///< 1 to LabelMap::kMostParts
    TransferFunction transferFunction;
    std::optional<float> gradientFactor;  ///< as Scene::gradientFactor; absent: the scene's own
    bool operator==(const PartCurve&) const = default;
};

struct Parts {
    /// On the grid of the scene's volume; null: there are no parts, or their map is still to be loaded.
    std::shared_ptr<const LabelMap> map;
    std::vector<PartCurve> curves;  ///< ascending labels; all others have the scene's own curve
    bool operator==(const Parts&) const = default;
};

struct Scene;

/// Returns the highest gradient factor of any tissue of a scene.
float highestGradientFactor(const Scene& scene);

/// Checks the parts of a scene: the map lies on the volume's grid, labels ascend, curves are valid, and the model is
/// not one of light from within, where sums over mixtures need too many steps; maximumIntensity, which shows no curve,
/// is the same with them. `where` of an error begins with "parts".
Result<void> checkParts(const Scene& scene);

}  // namespace pdr
