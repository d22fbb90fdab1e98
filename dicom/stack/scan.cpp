#include <sys/stat.h>

#include <algorithm>
#include <new>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "dicom/import.h"
#include "dicom/parallel.h"
#include "dicom/read/codecs.h"
#include "dicom/read/slice_header.h"
#include "dicom/stack/damaged_files.h"
#include "dicom/stack/grouping.h"
#include "render/base/errors.h"

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
    FileList(const fs::path& folder, const Progress& progress, ScanResult& result)
        : progress_(progress), result_(result) {
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
        std::sort(files_.begin(), files_.end());
    }

    /// Returns false if progress requested a stop.
    bool isComplete() const { return complete_; }
    std::vector<fs::path> take() { return std::move(files_); }

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
            result_.problems.push_back({link, phrase("the link leads nowhere")});
        else if (target.type() == fs::file_type::regular && isNew(link))
            files_.push_back(link);
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
                    files_.push_back(entry->path());
            }
            if (failure)
                result_.problems.push_back({current, phrase("the folder cannot be read (%1)", failure.message())});
            if (!progress_(0.0, "looking for files"))
                return false;
        }
        return true;
    }

    const Progress& progress_;
    ScanResult& result_;
    bool complete_ = false;
    std::vector<fs::path> files_, links_;
    std::set<std::pair<dev_t, ino_t>> seen_;
};

HeaderRead readWithinMemory(const fs::path& file, const GoOn& goOn) {
    try {
        return readSliceHeader(file, goOn);
    } catch (const std::bad_alloc&) {
        HeaderRead read;
        read.kind = HeaderRead::Kind::damaged;
        read.header.file = file;
        read.damage = phrase("there is not enough memory to read its header");
        return read;
    }
}

/// Sorts the headers into usable and damaged ones. `damaged` also receives what has no header: it may have been a
/// slice.
void sortOut(std::vector<HeaderRead>& reads, std::vector<SliceHeader>& headers, std::vector<SliceHeader>& damaged,
             ScanResult& result) {
    std::vector<fs::path> foreign;
    for (const Problem& problem : result.problems)
        damaged.push_back({.file = problem.file});
    for (HeaderRead& read : reads) {
        switch (read.kind) {
            case HeaderRead::Kind::notDicom:
                foreign.push_back(read.header.file);
                break;
            case HeaderRead::Kind::directory:
                break;
            case HeaderRead::Kind::damaged:
                result.problems.push_back({read.header.file, read.damage});
                damaged.push_back(std::move(read.header));
                break;
            case HeaderRead::Kind::object:
                headers.push_back(std::move(read.header));
                break;
        }
    }
    // Count foreign files that look like slices as damaged
    const std::vector<Problem> spoilt = spoiltFiles(foreign, headers);
    result.notDicom = int(foreign.size() - spoilt.size());
    for (const Problem& problem : spoilt) {
        result.problems.push_back(problem);
        damaged.push_back({.file = problem.file});
    }
}

}  // namespace

Result<ScanResult> scanFolder(const fs::path& folder, const Progress& progress) {
    if (const std::optional<Error> error = refuseFolder(folder))
        return *error;
    prepareToolkit();
    if (!dictionaryIsThere())
        return Error{phrase("the DICOM dictionary is not there, so no file can be read"), "",
                     phrase("Install libdcmtk17 again.")};
    // List the files
    ScanResult result;
    FileList list(folder, progress, result);
    if (!list.isComplete())
        return cancelled();
    const std::vector<fs::path> files = list.take();
    result.filesSeen = int(files.size());
    // Read their headers
    std::vector<HeaderRead> reads(files.size());
    const auto readOne = [&](std::size_t i, const GoOn& goOn) { reads[i] = readWithinMemory(files[i], goOn); };
    if (!onAllCores(files.size(), readOne, progress, "reading headers"))
        return cancelled();
    // Group the usable ones into series
    std::vector<SliceHeader> headers, damaged;
    sortOut(reads, headers, damaged, result);
    if (headers.empty() && result.problems.empty())
        return Error{result.filesSeen == 0 ? phrase("the folder is empty")
                                           : phrase("none of the %1 files is a DICOM image", result.filesSeen),
                     folder.string(), phrase("Give the folder that holds the DICOM files.")};
    result.series = groupIntoSeries(headers, damaged, folder, progress);
    if (!progress(1.0, "sorting slices"))
        return cancelled();
    std::sort(result.problems.begin(), result.problems.end(),
              [](const Problem& a, const Problem& b) { return a.file < b.file; });
    return result;
}

}  // namespace pdr::dicom
