#pragma once
/// A file that appears whole or not at all: written beside its place and renamed into it. An error, or being forgotten
/// before commit(), leaves an older file of that name as it was and nothing else behind.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "render/base/result.h"

namespace pdr {

class ReplacingFile {
  public:
    /// Errors: no such folder, no permission, `path` is a folder or something else that is no plain file.
    static Result<ReplacingFile> open(const std::filesystem::path& path);

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

    ReplacingFile(std::filesystem::path path, std::filesystem::path temporary, std::FILE* stream)
        : path_(std::move(path)), temporary_(std::move(temporary)), stream_(stream) {}
    bool remember(bool ok);

    std::filesystem::path path_;
    std::filesystem::path temporary_;  ///< empty once renamed
    std::unique_ptr<std::FILE, Closer> stream_;
    int failure_ = 0;  ///< errno of the first failure
};

}  // namespace pdr
