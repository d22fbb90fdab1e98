#pragma once
/// What `pdrender-cli plan` prints: the measurements of a plan.

#include <string>
#include <vector>

#include "app/plan/marks_table.h"

namespace pdr::app {

/// Returns a table for a person: a line for each place, the first with name, kind and value.
std::string plainText(const std::vector<MarkRow>& rows);

/// Returns a JSON object, "format": "pdrender-marks", "version": 1. Its keys are listed in
/// resources/manual/command-line.md. `onScan`: whether the values are those of the scan of the plan.
std::string jsonText(const std::vector<MarkRow>& rows, const ScanMark& scan, bool onScan);

}  // namespace pdr::app
