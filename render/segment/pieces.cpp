#include "render/segment/pieces.h"

#include <algorithm>

#include "render/segment/distance.h"

namespace pdr::segment {
namespace {

/// A union-find structure of piece numbers: each points to a lower number of the same piece, the lowest to itself.
class SameNumbers {
  public:
    std::int32_t add() {
        parent_.push_back(std::int32_t(parent_.size()));
        return parent_.back();
    }
    std::int32_t lowest(std::int32_t number) {
        while (parent_[std::size_t(number)] != number) {
            parent_[std::size_t(number)] = parent_[std::size_t(parent_[std::size_t(number)])];
            number = parent_[std::size_t(number)];
        }
        return number;
    }
    std::int32_t join(std::int32_t a, std::int32_t b) {
        a = lowest(a);
        b = lowest(b);
        parent_[std::size_t(std::max(a, b))] = std::min(a, b);
        return std::min(a, b);
    }
    /// Returns the final number of the piece of each number; 0 stays 0, and the others follow without a gap.
    std::vector<std::int32_t> numbered() {
        std::vector<std::int32_t> numbers(parent_.size());
        std::int32_t next = 0;
        for (std::size_t i = 1; i < parent_.size(); ++i) {
            const auto low = std::size_t(lowest(std::int32_t(i)));
            numbers[i] = low == i ? ++next : numbers[low];
        }
        return numbers;
    }

  private:
    std::vector<std::int32_t> parent_{0};
};

}  // namespace

Pieces piecesOf(const Cells& mask, const CellGrid& grid, const Checkpoint& checkpoint) {
    Pieces pieces{std::vector<std::int32_t>(grid.count()), 0};
    std::int32_t* of = pieces.of.data();
    const std::size_t row = std::size_t(grid.size.x), slice = grid.sliceCount();
    SameNumbers same;
    std::size_t i = 0;
    for (int z = 0; z < grid.size.z; ++z) {
        checkpoint();
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x, ++i) {
                if (!mask[i])
                    continue;
                for (const std::int32_t before :
                     {x > 0 ? of[i - 1] : 0, y > 0 ? of[i - row] : 0, z > 0 ? of[i - slice] : 0})
                    if (before != 0 && before != of[i])
                        of[i] = of[i] == 0 ? before : same.join(of[i], before);
                if (of[i] == 0)
                    of[i] = same.add();
            }
    }
    const std::vector<std::int32_t> numbers = same.numbered();
    checkpoint();
    for (std::int32_t& number : pieces.of)
        number = numbers[std::size_t(number)];
    pieces.count = *std::max_element(numbers.begin(), numbers.end());
    return pieces;
}

Cells piecesWith(const Cells& seeds, double least, const Cells& mask, const CellGrid& grid,
                 const Checkpoint& checkpoint) {
    const Pieces pieces = piecesOf(mask, grid, checkpoint);
    checkpoint();
    std::vector<std::size_t> held(std::size_t(pieces.count) + 1);
    for (std::size_t i = 0; i < mask.size(); ++i)
        held[std::size_t(pieces.of[i])] += seeds[i];
    Cells kept(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        kept[i] = mask[i] && double(held[std::size_t(pieces.of[i])]) >= least;
    return kept;
}

ThickPieces thickPieces(const Cells& mask, const std::vector<float>& squaredDepths, const CellGrid& grid,
                        double radiusMm, const Checkpoint& checkpoint) {
    const Pieces pieces = piecesOf(mask, grid, checkpoint);
    checkpoint();
    Cells isThick(std::size_t(pieces.count) + 1);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i] && atLeast(squaredDepths[i], radiusMm))
            isThick[std::size_t(pieces.of[i])] = 1;
    checkpoint();
    ThickPieces thick{Cells(mask.size()), int(std::count(isThick.begin(), isThick.end(), 1))};
    for (std::size_t i = 0; i < mask.size(); ++i)
        thick.cells[i] = isThick[std::size_t(pieces.of[i])];
    return thick;
}

}  // namespace pdr::segment
