#include "render/prepare/part_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "render/base/cells.h"
#include "render/kernel/transport/event.h"
#include "render/scene/scene.h"

namespace pdr {
namespace {

/// Returns the only curve of the voxels in a fine cell, or kMixedCell; 0 for a cell without voxels.
std::uint8_t curveOfCell(const LabelMap& map, const std::array<std::uint8_t, 256>& curveOf, ivec3 cell) {
    const ivec3 size = map.geometry.size;
    const VoxelSpan x = voxelsOfCell(cell.x, size.x), y = voxelsOfCell(cell.y, size.y),
                    z = voxelsOfCell(cell.z, size.z);
    if (x.first > x.last || y.first > y.last || z.first > z.last)
        return 0;
    const auto row = [&](int j, int k) {
        return map.labels.data() + (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
    };
    const std::uint8_t only = curveOf[row(y.first, z.first)[x.first]];
    for (int k = z.first; k <= z.last; ++k)
        for (int j = y.first; j <= y.last; ++j)
            for (int i = x.first; i <= x.last; ++i)
                if (curveOf[row(j, k)[i]] != only)
                    return kMixedCell;
    return only;
}

std::shared_ptr<const CellCurves> cellCurves(const LabelMap& map, const std::array<std::uint8_t, 256>& curveOf) {
    const ivec3 voxels = map.geometry.size;
    const ivec3 fine = coarseCells(voxels) * kFinePerCoarse;
    auto cells = std::make_shared<CellCurves>(std::size_t(fine.x) * std::size_t(fine.y) * std::size_t(fine.z));
    tbb::parallel_for(0, fine.z, [&](int k) {
        for (int j = 0; j < fine.y; ++j)
            for (int i = 0; i < fine.x; ++i)
                (*cells)[std::size_t(cellIndex({i, j, k}, fine))] = curveOfCell(map, curveOf, {i, j, k});
    });
    return cells;
}

/// A curve and how readily its tissue has surfaces.
struct Curve {
    const TransferFunction* function;
    float gradientFactor;
    bool operator==(const Curve& other) const {
        return gradientFactor == other.gradientFactor && *function == *other.function;
    }
};

/// Returns the different curves of a scene, its own first, and stores the number of each label's curve.
std::vector<Curve> differentCurves(const Scene& scene, std::array<std::uint8_t, 256>& materialOf) {
    std::vector<Curve> curves{{&scene.transferFunction, scene.gradientFactor}};
    for (const PartCurve& part : scene.parts.curves) {
        const Curve curve{&part.transferFunction, part.gradientFactor.value_or(scene.gradientFactor)};
        const auto known = std::ranges::find(curves, curve);
        materialOf[part.label] = std::uint8_t(known - curves.begin());
        if (known == curves.end())
            curves.push_back(curve);
    }
    return curves;
}

}  // namespace

bool hasShapeOfLabels(const TransferFunction& function) {
    const float opacity = function.nodes.front().opacity;
    return opacity > 0 &&
           std::ranges::all_of(function.nodes, [&](const TransferNode& node) { return node.opacity == opacity; });
}

void PartTables::take(const Scene& scene, const PartTables* last) {
    if (!scene.parts.map)
        return;
    const std::vector<Curve> different = differentCurves(scene, materialOf);
    if (different.size() == 1)
        return;
    map = scene.parts.map;
    std::vector<TransferTables> tables;
    std::vector<std::size_t> lookUps;
    lookUps.reserve(different.size());
    for (const Curve& curve : different)
        lookUps.push_back(add(tables.emplace_back(*curve.function)));
    curveOf = materialOf;
    for (int label = 0; label < 256; ++label) {
        const TransferTables& mine = tables[materialOf[std::size_t(label)]];
        const auto first = std::ranges::find_if(tables, [&](const auto& other) { return other.sameOpacity(mine); });
        curveOf[std::size_t(label)] = std::uint8_t(first - tables.begin());
    }
    // Point to the tables only now that they have their places.
    int first = 0;
    for (const TransferTables& one : tables) {
        FlatTransferFunction curve = one.flat();
        curve.pieces = pieces.data() + first;
        curve.materials = materials.data() + 2 * std::ptrdiff_t(first);
        curve.pieceAt = pieceAt.data() + lookUps[curves.size()];
        curve.firstPiece = first;
        const Curve& drawn = different[curves.size()];
        const bool byLabels = !curves.empty() && hasShapeOfLabels(*drawn.function);
        curve.surfaceFactor = surfaceFactorOf(drawn.gradientFactor) * (byLabels ? -1.0f : 1.0f);
        curves.push_back(curve);
        first += curve.pieceCount;
    }
    cells = last && last->map == map && last->curveOf == curveOf ? last->cells : cellCurves(*map, curveOf);
}

std::size_t PartTables::add(const TransferTables& tables) {
    pieces.insert(pieces.end(), tables.pieces.begin(), tables.pieces.end());
    materials.insert(materials.end(), tables.materials.begin(), tables.materials.end());
    for (std::size_t known = 0; known < pieceAt.size(); known += tables.pieceAt.size())
        if (std::equal(tables.pieceAt.begin(), tables.pieceAt.end(), pieceAt.begin() + std::ptrdiff_t(known)))
            return known;
    pieceAt.insert(pieceAt.end(), tables.pieceAt.begin(), tables.pieceAt.end());
    return pieceAt.size() - tables.pieceAt.size();
}

FlatParts PartTables::flat() const {
    if (empty())
        return {};
    return {map->labels.data(), materialOf.data(),  curveOf.data(),       cells->data(),
            curves.data(),      int(curves.size()), materialOf != curveOf};
}

bool PartTables::sameOpacity(const PartTables& other) const {
    const auto sameCurve = [](const FlatTransferFunction& a, const FlatTransferFunction& b) {
        return a.extinctionPerMm == b.extinctionPerMm && a.firstPiece == b.firstPiece && a.pieceCount == b.pieceCount;
    };
    return map == other.map && curveOf == other.curveOf && pieces == other.pieces &&
           std::ranges::equal(curves, other.curves, sameCurve);
}

}  // namespace pdr
