#pragma once
/// Reading of files that a user names. A pipe or a device instead of a file would block a program for ever or fill its
/// memory, so only plain files are opened.

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// Opens `path`, following links, and closes it again. Never blocks. Errors: the file does not exist, may not be read
/// or cannot be opened, each with the system's reason; it is a folder or no plain file.
Result<void> checkPlainFile(const std::filesystem::path& path);

/// Returns the bytes of the plain file `path`. Errors: those of checkPlainFile; more than `mostBytes`; a read that
/// fails.
Result<std::string> readPlainFile(const std::filesystem::path& path, std::uint64_t mostBytes);

}  // namespace pdr
