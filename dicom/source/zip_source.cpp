/// The ZIP archive as a source: its files, unpacked one at a time into memory. The archive's directory gives each a
/// place of its own, so any one is read without those before it.

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "dicom/import.h"
#include "dicom/source/zip_handle.h"
#include "render/base/errors.h"
#include "render/base/file_ending.h"
#include "render/base/free_memory.h"

namespace pdr::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostEntries = 100'000, kMostBytes = 64'000'000'000, kMostTimes = 200;

/// Returns whether the name is that of an archive; a packed volume is none.
bool isArchive(const fs::path& name) {
    static const std::set<std::string> kEndings{".zip", ".tar", ".gz", ".tgz", ".7z", ".rar", ".bz2", ".xz", ".zst"};
    return kEndings.contains(fileEnding(name)) && fileEnding(name.stem()) != ".nii";
}

/// Returns why the entry is left out; empty if it is not.
Text whyLeftOut(const ZipEntry& entry, const fs::path& name) {
    if (entry.isLink)
        return phrase("it is a link");
    if (name.is_absolute() || std::ranges::find(name, "..") != name.end())
        return phrase("its name leads out of the archive");
    if (isArchive(name))
        return phrase("it is an archive within the archive");
    return {};
}

/// The entries of an archive that are read, by name, and those that are left out.
struct Directory {
    std::map<fs::path, ZipEntry> entries;
    std::vector<Problem> leftOut;
};

Result<void> checkSize(std::uint64_t unpacked, const fs::path& archive) {
    std::error_code failure;
    const std::uint64_t packed = fs::file_size(archive, failure);
    if (!failure && unpacked <= kMostBytes && unpacked / kMostTimes <= packed)
        return {};
    return Error{
        phrase("the archive would unpack to %1, which is more than 64 GB or 200 times its size", bytesText(unpacked)),
        archive.string(), phrase("Unpack it, and open the folder."), ErrorKind::refused};
}

Result<Directory> directoryOf(const ZipHandle& handle, const fs::path& archive) {
    if (handle.count() > kMostEntries)
        return Error{phrase("the archive holds %1 files, more than 100000", handle.count()), archive.string(),
                     phrase("Unpack it, and open the folder."), ErrorKind::refused};
    Directory directory;
    std::uint64_t unpacked = 0;
    for (std::uint64_t i = 0; i < handle.count(); ++i) {
        Result<ZipEntry> entry = handle.entry(i);
        if (!entry)
            return entry.error().in(archive.string());
        if (entry->name.ends_with('/'))
            continue;
        if (entry->isEncrypted)
            return Error{phrase("the archive is encrypted"), archive.string(),
                         phrase("Unpack it with its password, and open the folder."), ErrorKind::refused};
        if (entry->bytes > kMostBytes)
            return checkSize(entry->bytes, archive).error();
        unpacked += entry->bytes;
        std::ranges::replace(entry->name, '\\', '/');  // as some programs of Windows write
        const fs::path name = entry->name;
        Text why = whyLeftOut(*entry, name);
        if (why.empty() && !directory.entries.emplace(archive / name, *entry).second)
            why = phrase("the archive holds another file of this name");
        if (!why.empty())
            directory.leftOut.push_back({archive / name.relative_path(), why});
    }
    if (auto ok = checkSize(unpacked, archive); !ok)
        return ok.error();
    return directory;
}

class ZipSource : public SeriesSource {
  public:
    ZipSource(fs::path archive, Directory directory) : archive_(std::move(archive)), directory_(std::move(directory)) {}

    fs::path root() const override { return archive_; }

    Result<Listing> list(const Progress&) const override {
        Listing listing{{}, directory_.leftOut};
        for (const auto& [name, entry] : directory_.entries)
            listing.names.push_back(name);
        if (listing.names.empty() && listing.problems.empty())
            return Error{phrase("the archive is empty"), archive_.string(), ""};
        return listing;
    }

    Result<NamedBytes> open(const fs::path& name) const override {
        const auto found = directory_.entries.find(name);
        if (found == directory_.entries.end())
            return Error{phrase("it is gone"), name.string(), ""};
        if (found->second.bytes > freeBytes())
            return notEnoughMemory({}, name.string(), phrase("Close other programs."));
        Result<ZipHandle> handle = idleHandle();
        if (!handle)
            return handle.error();
        Result<std::vector<std::uint8_t>> bytes = handle->read(found->second);
        if (!bytes)
            return bytes.error().in(name.string());
        const std::lock_guard lock(mutex_);
        idle_.push_back(*std::move(handle));
        return NamedBytes{name, std::make_shared<const std::vector<std::uint8_t>>(*std::move(bytes))};
    }

  private:
    /// Returns a handle that no thread uses: there come to be as many as threads that read at a time.
    Result<ZipHandle> idleHandle() const {
        const std::lock_guard lock(mutex_);
        if (idle_.empty())
            return ZipHandle::open(archive_);
        ZipHandle last = std::move(idle_.back());
        idle_.pop_back();
        return last;
    }

    const fs::path archive_;
    const Directory directory_;
    mutable std::mutex mutex_;
    mutable std::vector<ZipHandle> idle_;
};

}  // namespace

Result<std::shared_ptr<const SeriesSource>> openArchive(const fs::path& archive) {
    const Result<ZipHandle> handle = ZipHandle::open(archive);
    if (!handle)
        return handle.error();
    Result<Directory> directory = directoryOf(*handle, archive);
    if (!directory)
        return directory.error();
    return std::shared_ptr<const SeriesSource>(std::make_shared<ZipSource>(archive, *std::move(directory)));
}

}  // namespace pdr::dicom
