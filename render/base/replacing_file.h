#pragma once
/// A file that appears whole or not at all: written beside its place and renamed into it. An error, or being forgotten
/// before commit(), leaves an older file of that name as it was and nothing else behind.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "render/base/result.h"

namespace pdr {

/// Who may read a file that is new. One that is replaced keeps its mode and group.
enum class FileAccess {
    everybody,  ///< as the umask says
    owner,      ///< what shows a patient
};

class ReplacingFile {
  public:
    /// What can go wrong in the end is tried here: whoever will need hours for the content calls this before as well.
    /// Where `path` is a link, the file behind it is replaced. Errors: no such folder, no permission for the folder,
    /// for an older file or, in a sticky folder, for another user's file; links in a circle; `path` is a folder or no
    /// plain file.
    static Result<ReplacingFile> open(const std::filesystem::path& path, FileAccess access = FileAccess::everybody);

    ReplacingFile(ReplacingFile&& other) noexcept = default;
    ReplacingFile& operator=(ReplacingFile&&) = delete;
    ~ReplacingFile();

    /// The first failure is remembered for commit(); later calls then do nothing and answer false.
    bool write(const void* bytes, std::size_t count);
    bool seek(std::uint64_t position);
    std::uint64_t position();

    /// What failed so far, if anything did.
    Result<void> state() const;
    /// Puts the file in its place, safely on the disk. Errors: a write that failed before (disk full), rename.
    Result<void> commit();

  private:
    struct Closer {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };

    ReplacingFile(std::filesystem::path path, std::filesystem::path place, std::filesystem::path temporary,
                  std::FILE* stream)
        : path_(std::move(path)), place_(std::move(place)), temporary_(std::move(temporary)), stream_(stream) {}
    bool remember(bool ok);

    std::filesystem::path path_;       ///< as it was asked for
    std::filesystem::path place_;      ///< where that leads to, behind symbolic links
    std::filesystem::path temporary_;  ///< beside place_; empty once renamed
    std::optional<mode_t> mode_;       ///< of the older file
    std::unique_ptr<std::FILE, Closer> stream_;
    int failure_ = 0;  ///< errno of the first failure
};

}  // namespace pdr
