#pragma once
/// A file that appears complete or not at all: it is written beside its place and renamed into it. After an error, or
/// without commit(), an older file of that name stays as it was and nothing else is left behind.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "render/base/result.h"

namespace pdr {

/// Who may read a new file. A file that replaces an older one keeps its mode and group.
enum class FileAccess {
    everybody,  ///< everybody whom the umask allows
    owner,      ///< only the owner: for files that show a patient
};

class ReplacingFile {
  public:
    /// Opens a temporary file beside `path`. It checks all that could fail at the end, so callers that need hours for
    /// the content call it beforehand as well. If `path` is a link, the file behind it is replaced. Errors: no such
    /// folder; no permission for the folder, for an older file or, in a sticky folder, for another user's file; links
    /// in a circle; `path` is a folder or no plain file.
    static Result<ReplacingFile> open(const std::filesystem::path& path, FileAccess access = FileAccess::everybody);

    ReplacingFile(ReplacingFile&& other) noexcept = default;
    ReplacingFile& operator=(ReplacingFile&&) = delete;
    ~ReplacingFile();

    /// Writes bytes. The first failure is kept for commit(); later calls of write() and seek() then do nothing and
    /// return false.
    bool write(const void* bytes, std::size_t count);
    bool seek(std::uint64_t position);
    std::uint64_t position();

    /// Returns the first failure, if there was one.
    Result<void> state() const;
    /// Moves the file to its place, safely on the disk. Errors: a write that failed before (disk full); rename.
    Result<void> commit();

  private:
    struct Closer {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };

    ReplacingFile(std::filesystem::path path, std::filesystem::path place, std::filesystem::path temporary,
                  std::FILE* stream)
        : path_(std::move(path)), place_(std::move(place)), temporary_(std::move(temporary)), stream_(stream) {}
    bool remember(bool ok);

    std::filesystem::path path_;       ///< path that the caller gave
    std::filesystem::path place_;      ///< path behind symbolic links
    std::filesystem::path temporary_;  ///< path beside place_; empty once renamed
    std::optional<mode_t> mode_;       ///< mode of the older file; nothing if there is none
    std::unique_ptr<std::FILE, Closer> stream_;
    int failure_ = 0;  ///< errno of the first failure
};

/// Writes `text` as the whole content of `path`. Errors: those of ReplacingFile.
Result<void> writeWhole(std::string_view text, const std::filesystem::path& path, FileAccess access);

}  // namespace pdr
