#pragma once
/// Plans as files ("format": "pdrender-plan"). They hold what the user has set and measured, and what ties them to the
/// scan (scan_mark.h); nothing of the patient's identity, no path and no date. Reading is strict: an unknown, missing
/// or doubled field, or one out of its range, is an error that names it.

#include <filesystem>
#include <string>
#include <string_view>

#include "app/plan/plan.h"
#include "app/plan/scan_mark.h"

namespace pdr::app {

struct SavedPlan {
    ScanMark scan;
    Plan plan;
    bool operator==(const SavedPlan&) const = default;
};

/// Reads the text of a plan file. `where` is used in error texts.
Result<SavedPlan> planFromText(std::string_view text, std::string_view where);
/// Returns the text that planFromText() reads as an equal plan, to the bit. Environment images are not written.
std::string planText(SavedPlan saved);

/// Reads a plan file of at most 16 MB.
Result<SavedPlan> readPlan(const std::filesystem::path& file);
/// Writes a plan file, which only its owner may read. An older file stays until the new one is complete.
Result<void> writePlan(const SavedPlan& saved, const std::filesystem::path& file);

}  // namespace pdr::app
