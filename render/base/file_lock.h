#pragma once
/// A lock on a file that the system releases when the program which holds it ends, in whatever way.

#include <filesystem>
#include <optional>
#include <utility>

namespace pdr {

class FileLock {
  public:
    /// Locks `file`, and creates it for its owner alone if there is none. Returns nothing if another lock holds it or
    /// the file cannot be opened. On file systems without locks (flock) it always succeeds.
    static std::optional<FileLock> of(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;  ///< -1: moved away
};

}  // namespace pdr
