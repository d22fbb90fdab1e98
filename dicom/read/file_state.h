#pragma once
/// The state of a file in the file system, which shows whether it was replaced or overwritten.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>

namespace pdr::dicom {

struct FileState {
    dev_t device = 0;
    ino_t number = 0;
    off_t bytes = 0;
    std::int64_t writtenNs = 0, changedNs = 0;

    bool operator==(const FileState&) const = default;
};

/// Returns the state of a file; that of no file if it is gone.
FileState stateOf(const std::filesystem::path& file);

}  // namespace pdr::dicom
