#include <algorithm>
#include <iterator>
#include <new>
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

HeaderRead withoutHeader(const fs::path& name, Text damage) {
    HeaderRead read;
    read.kind = HeaderRead::Kind::damaged;
    read.header.file = name;
    read.damage = std::move(damage);
    return read;
}

HeaderRead readWithinMemory(const SeriesSource& source, const fs::path& name, const GoOn& goOn) {
    try {
        const Result<NamedBytes> object = source.open(name);
        return object ? readSliceHeader(*object, goOn) : withoutHeader(name, object.error().what);
    } catch (const std::bad_alloc&) {
        return withoutHeader(name, phrase("there is not enough memory to read its header"));
    }
}

/// Sorts the headers into usable and damaged ones. `damaged` also receives what has no header: it may have been a
/// slice.
void sortOut(const SeriesSource& source, std::vector<HeaderRead>& reads, std::vector<SliceHeader>& headers,
             std::vector<SliceHeader>& damaged, ScanResult& result) {
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
                if (read.frames.empty())
                    headers.push_back(std::move(read.header));
                std::ranges::move(read.frames, std::back_inserter(headers));
                break;
        }
    }
    // Count foreign files that look like slices as damaged
    const std::vector<Problem> spoilt = spoiltFiles(source, foreign, headers);
    result.notDicom = int(foreign.size() - spoilt.size());
    for (const Problem& problem : spoilt) {
        result.problems.push_back(problem);
        damaged.push_back({.file = problem.file});
    }
}

}  // namespace

Result<ScanResult> scanSource(const std::shared_ptr<const SeriesSource>& source, const Progress& progress) {
    prepareToolkit();
    if (!dictionaryIsThere())
        return Error{phrase("the DICOM dictionary is not there, so no file can be read"), "",
                     phrase("Install libdcmtk17 again.")};
    // List the objects
    Result<SeriesSource::Listing> listing = source->list(progress);
    if (!listing)
        return listing.error();
    const std::vector<fs::path>& names = listing->names;
    ScanResult result;
    result.problems = std::move(listing->problems);
    result.filesSeen = int(names.size());
    // Read their headers
    std::vector<HeaderRead> reads(names.size());
    const auto readOne = [&](std::size_t i, const GoOn& goOn) { reads[i] = readWithinMemory(*source, names[i], goOn); };
    if (!onAllCores(names.size(), readOne, progress, "reading headers"))
        return cancelled();
    // Group the usable ones into series
    std::vector<SliceHeader> headers, damaged;
    sortOut(*source, reads, headers, damaged, result);
    if (headers.empty() && result.problems.empty())
        return Error{result.filesSeen == 1 ? phrase("the only file is not a DICOM image")
                                           : phrase("none of the %1 files is a DICOM image", result.filesSeen),
                     source->root().string(), phrase("Give the folder that holds the DICOM files."),
                     ErrorKind::refused};
    result.series = groupIntoSeries(headers, damaged, source, progress);
    if (!progress(1.0, "sorting slices"))
        return cancelled();
    std::sort(result.problems.begin(), result.problems.end(),
              [](const Problem& a, const Problem& b) { return a.file < b.file; });
    return result;
}

}  // namespace pdr::dicom
