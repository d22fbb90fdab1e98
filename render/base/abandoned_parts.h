#pragma once
/// Files that were being written when their program was killed.

#include <filesystem>
#include <string_view>

namespace pdr {

/// What a file is called until it is whole: kPartStart, random letters, kPartEnd.
inline constexpr std::string_view kPartStart = ".pdr-", kPartEnd = ".part";

/// Claims the part behind `descriptor` as long as the file is open: others do not take it for abandoned.
void claimPart(int descriptor);

/// Removes from `folder` the parts of this user that were not written to for an hour and that nobody has claimed. Where
/// a disk knows no claims (flock) they stay.
void removeAbandonedParts(const std::filesystem::path& folder);

}  // namespace pdr
