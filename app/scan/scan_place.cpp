#include "app/scan/scan_place.h"

#include <utility>

#include "app/scan/grid_series.h"
#include "render/volume/file/scan_endings.h"

namespace pdr::app {

bool isScanFile(const std::filesystem::path& path) {
    std::error_code ignored;
    return !scanEnding(path).empty() && std::filesystem::is_regular_file(path, ignored);
}

Result<dicom::ScanResult> scanPlace(const std::filesystem::path& path, const Progress& progress) {
    if (!isScanFile(path))
        return dicom::scanFolder(path, progress);
    if (!isGridFile(path))
        return dicom::scanArchive(path, progress);
    Result<dicom::Series> series = gridSeries(path, progress);
    if (!series)
        return series.error();
    dicom::ScanResult scan;
    scan.series.push_back(*std::move(series));
    scan.filesSeen = 1;
    return scan;
}

Result<Volume> loadVoxels(const dicom::Series& series, dicom::Padding padding, const Progress& progress,
                          std::vector<dicom::Note>* notes) {
    if (dynamic_cast<const GridSource*>(series.source.get()))
        return loadGridSeries(series, progress);
    return dicom::loadSeries(series, padding, progress, notes);
}

}  // namespace pdr::app
