#include "render/prepare/met_tissue.h"

#include "render/kernel/bounds/cell_bound.h"

namespace pdr {

namespace {

/// Central differences over one voxel to each side are at most half the range of the HU, along every axis.
double steepestIn(const Volume& volume) {
    const HuRange range = volume.storedRange();
    if (range.lowest == range.highest)
        return 0;
    const double difference = 0.5 * (double(range.highest) - range.lowest) + kHuSlack;
    const glm::dmat3 perMm = glm::transpose(glm::inverse(glm::dmat3(volume.geometry().patientFromIndex)));
    return difference * (glm::length(perMm[0]) + glm::length(perMm[1]) + glm::length(perMm[2]));
}

}  // namespace

MetTissue::MetTissue(const TransferFunction& function, const Volume& volume)
    : extinctionPerMm_(function.extinctionPerMm), steepest_(steepestIn(volume)) {
    const TransferTables tables(function);
    const FlatTransferFunction flat = tables.flat();
    const HuRange range = volume.storedRange();
    highestOpacity_ = pdr::highestOpacity(flat, range);
    const float room = range.lowest < range.highest ? kHuSlack : 0;  // interpolation rounds
    const float low = float(range.lowest) - room, high = float(range.highest) + room;
    for (int i = pieceOf(flat, low); i < flat.pieceCount && tables.pieces[i].start <= high; ++i)
        if (pdr::highestOpacity(tables.pieces[i], low, high) > 0)
            materials_.insert(materials_.end(), {tables.materials[2 * i], tables.materials[2 * i + 1]});
}

}  // namespace pdr
