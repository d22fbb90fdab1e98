#include <algorithm>
#include <new>
#include <optional>
#include <system_error>

#include "dicom/codecs.h"
#include "dicom/grouping.h"
#include "dicom/import.h"
#include "dicom/parallel.h"
#include "dicom/slice_header.h"

namespace pdr::dicom {

namespace fs = std::filesystem;

namespace {

const Error kCancelled{"cancelled", "", ""};

std::optional<Error> refuseFolder(const fs::path& folder) {
    std::error_code failure;
    const fs::file_status status = fs::status(folder, failure);
    if (status.type() == fs::file_type::not_found)
        return Error{"there is no such folder", folder.string(), "Check the spelling."};
    if (status.type() == fs::file_type::none)
        return Error{"the folder cannot be looked into (" + failure.message() + ")", folder.string(),
                     "Ask its owner for permission to read."};
    if (status.type() != fs::file_type::directory)
        return Error{"this is a file, not a folder", folder.string(), "Give the folder that holds the DICOM files."};
    fs::directory_iterator(folder, failure);
    if (failure)
        return Error{"the folder cannot be read (" + failure.message() + ")", folder.string(),
                     "Ask its owner for permission to read."};
    return {};
}

/// Every regular file below `folder`, sorted by path; folders that cannot be entered become problems.
std::optional<std::vector<fs::path>> listFiles(const fs::path& folder, const Progress& progress, ScanResult& result) {
    std::vector<fs::path> files, open{folder};
    while (!open.empty()) {
        const fs::path current = std::move(open.back());
        open.pop_back();
        std::error_code failure;
        for (fs::directory_iterator entry(current, failure), end; !failure && entry != end; entry.increment(failure)) {
            std::error_code gone;
            const fs::file_status status = entry->symlink_status(gone);
            if (status.type() == fs::file_type::directory)
                open.push_back(entry->path());
            else if (status.type() == fs::file_type::regular)
                files.push_back(entry->path());
        }
        if (failure)
            result.problems.push_back({current, "the folder cannot be read (" + failure.message() + ")"});
        if (!progress(0.0, "looking for files"))
            return {};
    }
    std::sort(files.begin(), files.end());
    return files;
}

HeaderRead readWithinMemory(const fs::path& file) {
    try {
        return readSliceHeader(file);
    } catch (const std::bad_alloc&) {
        HeaderRead read;
        read.kind = HeaderRead::Kind::damaged;
        read.header.file = file;
        read.damage = "there is not enough memory to read its header";
        return read;
    }
}

void sortOut(std::vector<HeaderRead>& reads, std::vector<SliceHeader>& headers, std::vector<SliceHeader>& damaged,
             ScanResult& result) {
    for (HeaderRead& read : reads) {
        switch (read.kind) {
            case HeaderRead::Kind::notDicom:
                ++result.notDicom;
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
}

}  // namespace

Result<ScanResult> scanFolder(const fs::path& folder, const Progress& progress) {
    if (const std::optional<Error> error = refuseFolder(folder))
        return *error;
    prepareToolkit();
    if (!dictionaryIsThere())
        return Error{"the DICOM dictionary is not there, so no file can be read", "", "Install libdcmtk17 again."};
    ScanResult result;
    const auto files = listFiles(folder, progress, result);
    if (!files)
        return kCancelled;
    result.filesSeen = int(files->size());
    std::vector<HeaderRead> reads(files->size());
    const auto readOne = [&](std::size_t i) { reads[i] = readWithinMemory((*files)[i]); };
    if (!onAllCores(files->size(), readOne, progress, "reading headers"))
        return kCancelled;
    std::vector<SliceHeader> headers, damaged;
    sortOut(reads, headers, damaged, result);
    if (headers.empty() && result.problems.empty())
        return Error{result.filesSeen == 0
                         ? "the folder is empty"
                         : "none of the " + std::to_string(result.filesSeen) + " files is a DICOM image",
                     folder.string(), "Give the folder that holds the DICOM files."};
    result.series = groupIntoSeries(headers, damaged, folder, progress);
    if (!progress(1.0, "sorting slices"))
        return kCancelled;
    std::sort(result.problems.begin(), result.problems.end(),
              [](const Problem& a, const Problem& b) { return a.file < b.file; });
    return result;
}

}  // namespace pdr::dicom
