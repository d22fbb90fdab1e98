#pragma once
/// Finds foreign objects that a body touches: a table, a holder, a mattress.

#include <vector>

#include "render/segment/cell_grid.h"
#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Returns the cells of `body` that are long and thin and outside the rest of its outline: the residue of an opening by
/// 3 mm, in pieces of at least 1 ml and 60 mm. None where that opening would remove more than 15 % of the body, as it
/// would from a dry skull: then thin does not mean foreign.
///   squaredDepths   of the body's cells below its surface [mm^2], known to 10 mm
Cells touching(const Cells& body, const std::vector<float>& squaredDepths, const CellGrid& grid,
               const Checkpoint& checkpoint = goOn);

}  // namespace pdr::segment
