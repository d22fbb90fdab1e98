/// The folder as a source: its files, and those of the folders below.

#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "dicom/import.h"
#include "dicom/series_source.h"
#include "dicom/source/packed_object.h"
#include "render/base/errors.h"
#include "render/base/file_ending.h"

namespace pdr::dicom {

namespace fs = std::filesystem;

namespace {

std::optional<Error> refuseFolder(const fs::path& folder) {
    std::error_code failure;
    const fs::file_status status = fs::status(folder, failure);
    if (status.type() == fs::file_type::not_found)
        return Error{phrase("there is no such folder"), folder.string(), phrase("Check the spelling.")};
    if (status.type() == fs::file_type::none)
        return Error{phrase("the folder cannot be looked into (%1)", failure.message()), folder.string(),
                     phrase("Ask its owner for permission to read.")};
    if (status.type() != fs::file_type::directory)
        return Error{phrase("this is a file, not a folder"), folder.string(),
                     phrase("Give the folder that holds the DICOM files.")};
    const fs::directory_iterator opened(folder, failure);
    if (failure)
        return Error{phrase("the folder cannot be read (%1)", failure.message()), folder.string(),
                     phrase("Ask its owner for permission to read.")};
    return {};
}

/// Lists every regular file below `folder` once, whatever links lead to it. Files that are no links come first, so that
/// a file is known by its own name if it has one below `folder`.
class FileList {
  public:
    FileList(const fs::path& folder, const Progress& progress) : progress_(progress) {
        std::error_code failure;
        // A link to the folder itself or to one that holds it would read the whole disk.
        for (fs::path up = fs::canonical(folder, failure); !failure && up != up.root_path(); up = up.parent_path())
            isNew(up.parent_path());
        isNew(folder);
        complete_ = walk({folder});
        while (complete_ && !links_.empty()) {
            const std::vector<fs::path> links = std::exchange(links_, {});
            for (const fs::path& link : links)
                complete_ = complete_ && follow(link);
        }
        std::sort(found_.names.begin(), found_.names.end());
    }

    /// Returns false if progress requested a stop.
    bool isComplete() const { return complete_; }
    SeriesSource::Listing take() { return std::move(found_); }

  private:
    /// Returns whether no file or folder that was seen so far is the same.
    bool isNew(const fs::path& path) {
        struct stat facts {};
        return stat(path.c_str(), &facts) != 0 || seen_.emplace(facts.st_dev, facts.st_ino).second;
    }

    bool follow(const fs::path& link) {
        std::error_code failure;
        const fs::file_status target = fs::status(link, failure);
        if (target.type() == fs::file_type::not_found)
            found_.problems.push_back({link, phrase("the link leads nowhere")});
        else if (target.type() == fs::file_type::regular && isNew(link))
            found_.names.push_back(link);
        else if (target.type() == fs::file_type::directory && isNew(link))
            return walk({link});
        return true;
    }

    bool walk(std::vector<fs::path> open) {
        while (!open.empty()) {
            const fs::path current = std::move(open.back());
            open.pop_back();
            std::error_code failure;
            for (fs::directory_iterator entry(current, failure), end; !failure && entry != end;
                 entry.increment(failure)) {
                std::error_code gone;
                const fs::file_type type = entry->symlink_status(gone).type();
                if (type == fs::file_type::symlink)
                    links_.push_back(entry->path());
                else if (type == fs::file_type::directory && isNew(entry->path()))
                    open.push_back(entry->path());
                else if (type == fs::file_type::regular && isNew(entry->path()))
                    found_.names.push_back(entry->path());
            }
            if (failure)
                found_.problems.push_back({current, phrase("the folder cannot be read (%1)", failure.message())});
            if (!progress_(0.0, "looking for files"))
                return false;
        }
        return true;
    }

    const Progress& progress_;
    SeriesSource::Listing found_;
    bool complete_ = false;
    std::vector<fs::path> links_;
    std::set<std::pair<dev_t, ino_t>> seen_;
};

class FolderSource : public SeriesSource {
  public:
    explicit FolderSource(fs::path folder) : folder_(std::move(folder)) {}

    fs::path root() const override { return folder_; }

    Result<Listing> list(const Progress& progress) const override {
        if (const std::optional<Error> error = refuseFolder(folder_))
            return *error;
        FileList files(folder_, progress);
        if (!files.isComplete())
            return cancelled();
        Listing found = files.take();
        if (found.names.empty() && found.problems.empty())
            return Error{phrase("the folder is empty"), folder_.string(),
                         phrase("Give the folder that holds the DICOM files.")};
        return found;
    }

    /// A file that gzip has packed is unpacked into memory.
    Result<NamedBytes> open(const fs::path& name) const override {
        return fileEnding(name) == ".gz" ? openPacked(name) : NamedBytes{name};
    }

  private:
    fs::path folder_;
};

}  // namespace

Result<ScanResult> scanFolder(const fs::path& folder, const Progress& progress) {
    return scanSource(std::make_shared<FolderSource>(folder), progress);
}

}  // namespace pdr::dicom
