#include "render/prepare/transfer_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr {

namespace {

constexpr float kBeyondAnyHu = 1e9f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Material materialOf(const TransferNode& node) {
    return {node.albedo, node.emission, node.specular, node.roughness};
}

}  // namespace

TransferTables::TransferTables(const TransferFunction& function) : extinctionPerMm(function.extinctionPerMm) {
    // Make a piece between neighbouring nodes of different HU, and constant pieces at both ends.
    const std::vector<TransferNode>& nodes = function.nodes;
    const auto add = [&](float start, float end, const TransferNode& from, const TransferNode& to) {
        const float slope = (to.opacity - from.opacity) / (end - start);
        pieces.push_back({std::max(start, -kBeyondAnyHu), end, from.opacity, std::isfinite(slope) ? slope : 0});
        materials.push_back(materialOf(from));
        materials.push_back(materialOf(to));
    };
    add(-kInfinity, nodes.front().hu, nodes.front(), nodes.front());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        if (nodes[i].hu < nodes[i + 1].hu)
            add(nodes[i].hu, nodes[i + 1].hu, nodes[i], nodes[i + 1]);
    add(nodes.back().hu, kInfinity, nodes.back(), nodes.back());

    // Find the first piece of each bucket of 16 HU.
    pieceAt.resize(65536 / 16);
    std::uint16_t piece = 0;
    for (std::size_t bucket = 0; bucket < pieceAt.size(); ++bucket) {
        // int(hu) rounds towards 0, so a negative bucket reaches one HU below its first whole number.
        const float lowest = float(int(bucket) * 16 - 32768) - 1;
        while (lowest >= pieces[piece].end)
            ++piece;
        pieceAt[bucket] = piece;
    }
}

FlatTransferFunction TransferTables::flat() const {
    return {pieces.data(), materials.data(), pieceAt.data(), int(pieces.size()), extinctionPerMm};
}

float TransferTables::highestOpacity() const {
    return std::ranges::max(pieces, {}, &OpacityPiece::opacity).opacity;
}

bool TransferTables::sameOpacity(const TransferTables& other) const {
    return extinctionPerMm == other.extinctionPerMm && pieces == other.pieces;
}

}  // namespace pdr
