#include "render/slice/unit_window.h"

#include <algorithm>

#include "render/slice/window_presets.h"

namespace pdr {

GreyWindow inVoxels(const GreyWindow& window, const ValueUnit& unit) {
    constexpr double kNarrowest = 1e-3;
    GreyWindow values = window;
    if (!unit.isPlain() && window.function == VoiFunction::linear)
        values = {window.centre - 0.5, std::max(window.width - 1, kNarrowest * unit.step), VoiFunction::linearExact};
    return {unit.voxelOf(values.centre), values.width / unit.step, values.function};
}

GreyWindow inValues(const GreyWindow& window, const ValueUnit& unit) {
    return {unit.valueOf(window.centre), window.width * unit.step, window.function};
}

GreyWindow firstWindow(const Volume& volume, const std::optional<GreyWindow>& stated) {
    const ValueUnit unit = unitOf(volume);
    if (stated)
        return inVoxels(*stated, unit);
    return unit.isHu ? GreyWindow() : wholeRange(volume);
}

}  // namespace pdr
