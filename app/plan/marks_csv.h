#pragma once
/// Measurements as comma-separated values (RFC 4180) in UTF-8, one row each, for spreadsheets and statistics. The
/// columns are listed in resources/manual/plans.md; they stay, and new ones come after them.

#include <string>
#include <vector>

#include "app/plan/marks_table.h"

namespace pdr::app {

/// Returns the text of the file. Numbers have a decimal point in every language. What is not known is empty: the ± of
/// typed places, places that a kind does not have. A text that a spreadsheet might take for a formula has an apostrophe
/// in front.
std::string marksCsv(const std::vector<MarkRow>& rows);

}  // namespace pdr::app
