#include "render/volume/label_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pdr {
namespace {

constexpr double kOffVoxels = 0.2, kOffMm = 0.2;  ///< how far voxels may lie apart that are taken for the same

/// Voxel `index` of a map as voxel turn * index + shift of the scan.
struct Lattice {
    dmat3 turn{1.0};  ///< each row and each column has one number that is not 0: 1 or -1
    dvec3 shift{0};
    double offVoxels = 0, offMm = 0;  ///< by how much the voxels lie apart at most

    bool isSame() const { return offVoxels <= kOffVoxels && offMm <= kOffMm; }
};

/// Returns the corner of a grid, index space: `edge` 0 for the centres of its outermost voxels, 0.5 for their edges.
dvec3 cornerOf(const ivec3& size, int corner, double edge) {
    const dvec3 end(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    return end * dvec3(size - 1) + edge * (2.0 * end - 1.0);
}

bool isTurn(const dmat3& turn) {
    for (int i = 0; i < 3; ++i) {
        double column = 0, row = 0;
        for (int j = 0; j < 3; ++j) {
            column += std::abs(turn[i][j]);
            row += std::abs(turn[j][i]);
        }
        if (column != 1 || row != 1)
            return false;
    }
    return true;
}

/// Returns how the voxels of `map` are those of `scan`; none if their steps are others.
std::optional<Lattice> latticeOf(const VolumeGeometry& scan, const VolumeGeometry& map) {
    const dmat4 scanFromMap = glm::inverse(scan.patientFromIndex) * map.patientFromIndex;
    Lattice lattice;
    lattice.turn =
        dmat3(glm::round(dvec3(scanFromMap[0])), glm::round(dvec3(scanFromMap[1])), glm::round(dvec3(scanFromMap[2])));
    if (!isTurn(lattice.turn))
        return {};
    const dvec3 middle = dvec3(map.size - 1) / 2.0;
    const dvec3 off = dvec3(scanFromMap * dvec4(middle, 1)) - lattice.turn * middle;
    lattice.shift = glm::round(off);
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 index = cornerOf(map.size, corner, 0);
        const dvec3 apart = dvec3(scanFromMap * dvec4(index, 1)) - (lattice.turn * index + lattice.shift);
        const dvec3 strain = apart - (off - lattice.shift);  // what no shift explains
        if (glm::length(strain) > kOffVoxels)
            return {};
        lattice.offVoxels = std::max({lattice.offVoxels, std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
        lattice.offMm = std::max(lattice.offMm, glm::length(dmat3(scan.patientFromIndex) * apart));
    }
    return lattice;
}

/// Returns how far the box of `map` reaches beyond that of `scan`, voxel extents included, in voxels of the scan.
double beyond(const VolumeGeometry& scan, const VolumeGeometry& map) {
    const dmat4 scanFromMap = glm::inverse(scan.patientFromIndex) * map.patientFromIndex;
    double worst = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 at = scanFromMap * dvec4(cornerOf(map.size, corner, 0.5), 1);
        for (int axis = 0; axis < 3; ++axis)
            worst = std::max({worst, -0.5 - at[axis], at[axis] + 0.5 - double(scan.size[axis])});
    }
    return worst;
}

/// Returns how far a map may reach beyond the scan: an edge of its own voxels, in voxels of the scan.
double mayReach(const VolumeGeometry& scan, const VolumeGeometry& map) {
    const dvec3 mm = map.spacingMm() / scan.spacingMm();
    return std::max({mm.x, mm.y, mm.z}) - 1 + kOffVoxels;
}

/// The axes along which a map would fit if it were mirrored.
struct Flip {
    dvec3 signs;
    Text exchanged;
};

std::optional<Flip> fittingFlip(const VolumeGeometry& scan, const VolumeGeometry& map) {
    const Flip flips[] = {{{-1, 1, 1}, phrase("left and right")},
                          {{-1, -1, 1}, phrase("left and right, and front and back,")},
                          {{1, -1, 1}, phrase("front and back")},
                          {{1, 1, -1}, phrase("head and feet")}};
    for (const Flip& flip : flips) {
        VolumeGeometry mirrored = map;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                mirrored.patientFromIndex[column][row] *= flip.signs[row];
        const auto lattice = latticeOf(scan, mirrored);
        if (lattice && lattice->isSame() && beyond(scan, mirrored) <= mayReach(scan, mirrored))
            return flip;
    }
    return {};
}

Error refusedMap(const Text& what, const Text& hint) {
    return {what, "", hint, ErrorKind::refused};
}

Error mirroredMap(const Text& what) {
    return refusedMap(what, phrase("Export it again from the program that made it, from this scan."));
}

Text stepsText(const VolumeGeometry& grid) {
    const dvec3 mm = grid.spacingMm();
    return phrase("%1 x %2 x %3 mm", numberOf(mm.x, 3), numberOf(mm.y, 3), numberOf(mm.z, 3));
}

/// Refuses what lies elsewhere, or nowhere, or beside the voxels of the scan.
Result<void> checkPlace(const VolumeGeometry& scan, const VolumeGeometry& map) {
    constexpr double kFlattest = 0.1;  // volume of a voxel, of that with upright axes
    const dvec3 mm = map.spacingMm();
    if (!(std::abs(glm::determinant(dmat3(map.patientFromIndex))) >= kFlattest * mm.x * mm.y * mm.z))
        return refusedMap(phrase("the axes of the label map lie in one plane"),
                          phrase("Export it again from the program that made it, from this scan."));
    const double reach = beyond(scan, map);
    const auto lattice = latticeOf(scan, map);
    if (lattice && !lattice->isSame() && reach < 1)
        return refusedMap(
            phrase("the label map is shifted: its voxels lie %1 mm (%2 voxels) beside those of the scan",
                   numberOf(lattice->offMm, 3), numberOf(lattice->offVoxels, 2)),
            phrase("Export it again on the grid of the scan; half a voxel is what is missing where voxels "
                   "are counted from their corners."));
    if (reach <= mayReach(scan, map))
        return {};
    if (const auto flip = fittingFlip(scan, map))
        return mirroredMap(phrase("the label map is mirrored: it fits the scan with %1 exchanged", flip->exchanged));
    return refusedMap(phrase("the label map lies elsewhere: it reaches %1 voxels beyond the scan", numberOf(reach, 3)),
                      phrase("It may be of another scan or patient: choose the series that it was made on."));
}

/// Calls fill(z) for each slice of a map on the grid `scan`, which must write all its labels.
template <class Fill>
LabelMap mapOn(const VolumeGeometry& scan, LabelMap&& map, const Fill& fill) {
    HugePageVector<std::uint8_t> labels(scan.voxelCount());
    const std::size_t slice = std::size_t(scan.size.x) * std::size_t(scan.size.y);
    tbb::parallel_for(0, scan.size.z, [&](int z) { fill(z, labels.data() + std::size_t(z) * slice); });
    map.labels = std::move(labels);
    map.geometry = scan;
    return std::move(map);
}

/// Returns the labels of the nearest voxels of `map`, by its indices of the scan's voxels.
LabelMap nearestLabels(const VolumeGeometry& scan, LabelMap map, const dmat4& mapFromScan) {
    const HugePageVector<std::uint8_t> old = std::move(map.labels);
    const ivec3 size = map.geometry.size;
    return mapOn(scan, std::move(map), [&](int z, std::uint8_t* out) {
        for (int y = 0; y < scan.size.y; ++y)
            for (int x = 0; x < scan.size.x; ++x) {
                const ivec3 at = ivec3(glm::floor(dvec3(mapFromScan * dvec4(x, y, z, 1)) + 0.5));
                const bool isInside =
                    glm::all(glm::greaterThanEqual(at, ivec3(0))) && glm::all(glm::lessThan(at, size));
                *out++ = isInside
                             ? old[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                                   std::size_t(at.x)]
                             : std::uint8_t(0);
            }
    });
}

bool isWhole(const Lattice& lattice, const VolumeGeometry& scan, const VolumeGeometry& map) {
    return lattice.turn == dmat3(1.0) && lattice.shift == dvec3(0) && map.size == scan.size;
}

LabelMap onWholeScan(const VolumeGeometry& scan, LabelMap map) {
    map.geometry = scan;
    return map;
}

dmat4 mapOf(const Lattice& lattice) {
    dmat4 all(lattice.turn);
    all[3] = dvec4(lattice.shift, 1);
    return all;
}

}  // namespace

Result<LabelMap> labelsOn(const VolumeGeometry& scan, LabelMap map, Resampling resampling) {
    if (auto ok = checkPlace(scan, map.geometry); !ok)
        return ok.error();
    if (const auto crossed = crossedSides(map))
        return mirroredMap(
            phrase("the label map is mirrored: \"%1\" lies at the right of \"%2\"", crossed->left, crossed->right));
    if (const auto lattice = latticeOf(scan, map.geometry))
        return isWhole(*lattice, scan, map.geometry)
                   ? onWholeScan(scan, std::move(map))
                   : nearestLabels(scan, std::move(map), glm::inverse(mapOf(*lattice)));
    if (resampling == Resampling::refused)
        return refusedMap(phrase("the label map has voxels of %1, the scan of %2, or they are turned",
                                 stepsText(map.geometry), stepsText(scan)),
                          phrase("Have it resampled to the nearest voxels, or export it on the grid of the scan."));
    map.notes.push_back(phrase("resampled to the nearest of voxels of %1", stepsText(map.geometry)));
    const dmat4 mapFromScan = glm::inverse(map.geometry.patientFromIndex) * scan.patientFromIndex;
    return nearestLabels(scan, std::move(map), mapFromScan);
}

}  // namespace pdr
