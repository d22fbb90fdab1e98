#pragma once
/// One open ZIP archive. The only part that calls libzip.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/base/result.h"

struct zip;

namespace pdr::dicom {

/// What the directory of an archive says about an entry.
struct ZipEntry {
    std::uint64_t index = 0;
    std::string name;         ///< as stored, UTF-8; a slash at its end: a folder
    std::uint64_t bytes = 0;  ///< unpacked
    bool isLink = false, isEncrypted = false;
};

/// For one thread at a time.
class ZipHandle {
  public:
    /// Opens an archive. Errors: those of checkPlainFile(); it is no ZIP archive, damaged or cut off.
    static Result<ZipHandle> open(const std::filesystem::path& archive);

    std::uint64_t count() const;
    /// Returns what is known of entry `index`, below count(). Errors: its place in the directory is damaged.
    Result<ZipEntry> entry(std::uint64_t index) const;
    /// Unpacks an entry into memory, no more than it states. Errors: damaged, cut off, of another length than stated or
    /// with a wrong checksum; a method that is not known.
    Result<std::vector<std::uint8_t>> read(const ZipEntry& entry) const;

  private:
    struct Close {
        void operator()(zip* archive) const;
    };
    explicit ZipHandle(zip* archive) : archive_(archive) {}

    std::unique_ptr<zip, Close> archive_;
};

}  // namespace pdr::dicom
