#pragma once
/// Files that a user names, as they are opened for reading: a pipe or a device in a file's place would stop a program
/// for ever, or fill its memory.

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// Opens `path`, links followed, and closes it again. Never waits. Errors: it is not there, may not be read, cannot be
/// opened, each with the system's reason; it is a folder, or no plain file.
Result<void> checkPlainFile(const std::filesystem::path& path);

/// The bytes of the plain file `path`. Errors: those of checkPlainFile, more than `mostBytes`, a read that fails.
Result<std::string> readPlainFile(const std::filesystem::path& path, std::uint64_t mostBytes);

}  // namespace pdr
