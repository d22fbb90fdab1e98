#pragma once
/// Files that take measurements to other programs. They hold what a plan holds of its measurements: nothing of the
/// patient's identity but what was typed as a name.

#include <filesystem>
#include <vector>

#include "app/plan/marks_table.h"

namespace pdr::app {

/// Returns whether the ending of `file`, in small letters or capitals, is one that writeMarks() writes: ".csv" or
/// ".mrk.json".
bool isMarksFile(const std::filesystem::path& file);

/// Writes the rows in the format of the file's ending. Only its owner may read the file; an older one stays until the
/// new one is complete. Errors: another ending; no rows; those of ReplacingFile.
Result<void> writeMarks(const std::vector<MarkRow>& rows, const std::filesystem::path& file);

}  // namespace pdr::app
