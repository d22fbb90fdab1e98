#pragma once
/// Measurements as a markups file of 3D Slicer (.mrk.json), schema 1.0.3, in LPS and millimetres. Slicer computes
/// lengths and angles of its own beside the values that were stated here.

#include <string>
#include <vector>

#include "app/plan/marks_table.h"

namespace pdr::app {

/// Returns the text of the file. The marks are locked, so that a touch in Slicer does not part them from their values.
std::string marksForSlicer(const std::vector<MarkRow>& rows);

}  // namespace pdr::app
