#pragma once
/// The parts of a scan as the list and the slices show them.

#include "app/document/document.h"
#include "app/jobs/slice_tint.h"
#include "ui/parts/part_row.h"

namespace pdr::app {

/// Returns the rows of the list: the rest of the body, and each part; none without parts.
std::vector<ui::PartRow> partRows(const Document& document);

/// Returns the colours of all parts that are not hidden.
SliceTint partTint(const Document& document);

/// What a look shows that the scan has not.
enum class MissingParts {
    none,
    vessels,  ///< rules can find these
    shells,
    mirror,
    metal,
    labels  ///< only a label map has them
};
MissingParts missingParts(const Document& document);

/// Returns what is to be known of the parts, in sentences: of each source, and where the image does not show them.
QString partNotes(const Document& document);

}  // namespace pdr::app
