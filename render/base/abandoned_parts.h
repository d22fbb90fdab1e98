#pragma once
/// Removal of unfinished files that a program left behind when it was killed while writing them.

#include <filesystem>
#include <string_view>

namespace pdr {

/// Name of a file until it is complete: kPartStart, random letters, kPartEnd.
inline constexpr std::string_view kPartStart = ".pdr-", kPartEnd = ".part";

/// Claims the unfinished file behind `descriptor` while it is open, so that others do not take it for abandoned.
void claimPart(int descriptor);

/// Removes from `folder` the unfinished files of this user that nobody has written to for an hour and that are not
/// claimed. On file systems without claims (flock) they stay.
void removeAbandonedParts(const std::filesystem::path& folder);

}  // namespace pdr
