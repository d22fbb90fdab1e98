#include "app/scan/scan_place.h"

#include <algorithm>
#include <utility>

#include "app/scan/grid_series.h"
#include "render/base/errors.h"
#include "render/volume/file/scan_endings.h"

namespace pdr::app {

namespace fs = std::filesystem;

namespace {

/// The files of a place, and the way to their bytes.
struct Files {
    fs::path root;  ///< what their names begin with
    int count = 0;
    std::vector<fs::path> grids;  ///< the volume files among them, by name
    OpenBytes open = onDisk;
    std::vector<dicom::Problem> leftOut{};  ///< what could not be looked into

    void add(const fs::path& name) {
        ++count;
        const bool isHidden = name.filename().string().starts_with('.');  // macOS puts "._a.nii" beside a.nii
        if (!isHidden && isGridFile(name))
            grids.push_back(name);
    }
};

/// Returns the files below a folder, links left out.
Files filesIn(const fs::path& folder) {
    Files files{.root = folder};
    std::error_code failure;
    constexpr auto kQuietly = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, kQuietly, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        std::error_code gone;
        if (entry->symlink_status(gone).type() == fs::file_type::regular)
            files.add(entry->path());
    }
    std::ranges::sort(files.grids);
    return files;
}

/// Adds an entry for each volume file, or the reason why there is none. Error: cancelled().
Result<void> addGrids(dicom::ScanResult& scan, const Files& files, const Progress& progress) {
    const std::vector<fs::path>& grids = files.grids;
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const double all = double(grids.size());
        Result<dicom::Series> series =
            gridSeries(grids[i], partOf(progress, double(i) / all, double(i + 1) / all), files.open);
        if (!series && series.error().kind == ErrorKind::cancelled)
            return series.error();
        scan.notDicom = std::max(scan.notDicom - 1, 0);
        if (!series) {
            scan.problems.push_back({grids[i], series.error().what});
            continue;
        }
        series->series.uid = grids[i].lexically_relative(files.root).generic_string();
        series->series.number = int(i + 1);
        scan.series.push_back(*std::move(series));
    }
    const auto rank = [](const dicom::Series& each) { return std::pair(!each.verdict.loadable(), !each.unit.isHu); };
    std::ranges::stable_sort(scan.series, {}, rank);
    return {};
}

/// Lists the DICOM files that `scanDicom` finds, and the volume files beside them.
template <class ScanDicom>
Result<dicom::ScanResult> scanFiles(const Files& files, const Progress& progress, ScanDicom scanDicom) {
    if (files.grids.empty())
        return scanDicom(progress);
    Result<dicom::ScanResult> scan = scanDicom(partOf(progress, 0, 0.5));
    if (!scan && scan.error().kind != ErrorKind::refused)
        return scan;
    if (!scan) {  // no DICOM in it
        scan = dicom::ScanResult();
        scan->filesSeen = scan->notDicom = files.count;
        scan->problems = files.leftOut;
    }
    if (auto ok = addGrids(*scan, files, partOf(progress, 0.5, 1)); !ok)
        return ok.error();
    return scan;
}

Result<dicom::ScanResult> scanWholeFolder(const fs::path& folder, const Progress& progress) {
    return scanFiles(filesIn(folder), progress, [&](const Progress& part) { return dicom::scanFolder(folder, part); });
}

Result<dicom::ScanResult> scanWholeArchive(const fs::path& archive, const Progress& progress) {
    const auto source = dicom::openArchive(archive);
    if (!source)
        return source.error();
    const auto listing = (*source)->list(progress);
    if (!listing)
        return listing.error();
    Files files{.root = archive,
                .open = [source = *source](const fs::path& name) { return source->open(name); },
                .leftOut = listing->problems};
    for (const fs::path& name : listing->names)
        files.add(name);
    return scanFiles(files, progress, [&](const Progress& part) { return dicom::scanSource(*source, part); });
}

Result<dicom::ScanResult> scanGrid(const fs::path& file, const Progress& progress) {
    Result<dicom::Series> series = gridSeries(file, progress);
    if (!series)
        return series.error();
    dicom::ScanResult scan;
    scan.series.push_back(*std::move(series));
    scan.filesSeen = 1;
    return scan;
}

}  // namespace

bool isScanFile(const fs::path& path) {
    std::error_code ignored;
    return !scanEnding(path).empty() && fs::is_regular_file(path, ignored);
}

Result<dicom::ScanResult> scanPlace(const fs::path& path, const Progress& progress) {
    if (!isScanFile(path))
        return scanWholeFolder(path, progress);
    return isGridFile(path) ? scanGrid(path, progress) : scanWholeArchive(path, progress);
}

Result<Volume> loadVoxels(const dicom::Series& series, dicom::Padding padding, const Progress& progress,
                          std::vector<dicom::Note>* notes, const dicom::OnArrival& onArrival) {
    if (dynamic_cast<const GridSource*>(series.source.get()))
        return loadGridSeries(series, progress);
    return dicom::loadSeries(series, padding, progress, notes, onArrival);
}

Result<dicom::DecodedSlice> decodeSliceOf(const dicom::Series& series, const dicom::SliceRef& slice,
                                          const std::stop_token& stop) {
    if (dynamic_cast<const GridSource*>(series.source.get()))
        return decodeGridSlice(series, slice, stop);
    return dicom::decodeSlice(series, slice, dicom::Padding::maskAsAir);
}

}  // namespace pdr::app
