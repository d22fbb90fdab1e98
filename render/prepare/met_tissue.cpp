#include "render/prepare/met_tissue.h"

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

namespace {

/// Returns a bound on the gradients of the HU in a volume [HU/mm]. Of the four weights that voxels have in the slope of
/// a cubic B-spline, the positive ones add up to 3/4 at most, half-way between two voxels, so that the slope along each
/// axis is at most that part of the range of the HU. The slope is taken between values of two sums each, and a sum may
/// be rounded by kHuSlack.
double steepestIn(const Volume& volume) {
    const HuRange range = volume.storedRange();
    if (range.lowest == range.highest)
        return 0;
    const double difference = 0.75 * (double(range.highest) - range.lowest) + 4 * kHuSlack;
    const glm::dmat3 perMm = glm::transpose(glm::inverse(glm::dmat3(volume.geometry().patientFromIndex)));
    return difference * (glm::length(perMm[0]) + glm::length(perMm[1]) + glm::length(perMm[2]));
}

}  // namespace

MetTissue::MetTissue(const Scene& scene) : steepest_(steepestIn(*scene.volume)) {
    const HuRange range = scene.volume->storedRange();
    add(scene.transferFunction, range);
    for (const PartCurve& part : scene.parts.curves)
        if (scene.parts.map)
            add(part.transferFunction, range);
}

void MetTissue::add(const TransferFunction& function, HuRange range) {
    const TransferTables tables(function);
    const FlatTransferFunction flat = tables.flat();
    const float highest = function.extinctionPerMm > 0 ? pdr::highestOpacity(flat, range) : 0;
    highestOpacity_ = std::max(highestOpacity_, highest);
    highestExtinction_ = std::max(highestExtinction_, double(function.extinctionPerMm) * highest);
    if (!(highest > 0))
        return;
    const float room = range.lowest < range.highest ? kHuSlack : 0;  // interpolation rounds
    const float low = float(range.lowest) - room, high = float(range.highest) + room;
    for (int i = pieceOf(flat, low); i < flat.pieceCount && tables.pieces[i].start <= high; ++i)
        if (pdr::highestOpacity(tables.pieces[i], low, high) > 0)
            materials_.insert(materials_.end(), {tables.materials[2 * i], tables.materials[2 * i + 1]});
}

}  // namespace pdr
