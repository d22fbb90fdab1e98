#include "app/scan/scan_labels.h"

#include <system_error>

#include "dicom/segmentation/segmentation.h"
#include "render/volume/file/label_file.h"
#include "render/volume/file/label_folder.h"

namespace pdr::app {

Result<LabelMap> readLabels(const std::filesystem::path& file, const VolumeGeometry& scan, const dicom::Series* series,
                            const Progress& progress) {
    static const dicom::Series kNone;  // of a raw file nothing is known that a segmentation could contradict
    std::error_code unknown;
    if (std::filesystem::is_directory(file, unknown))
        return readLabelFolder(file, progress);
    if (isGridFile(file))
        return readLabelFile(file, progress);
    return dicom::readSegmentation({file}, series ? *series : kNone, scan, progress);
}

Result<LabelMap> readScanLabels(const std::filesystem::path& file, const VolumeGeometry& scan,
                                const dicom::Series* series, Resampling resampling, const Progress& progress) {
    Result<LabelMap> map = readLabels(file, scan, series, progress);
    if (!map)
        return map;
    Result<LabelMap> placed = labelsOn(scan, *std::move(map), resampling);
    return placed ? std::move(placed) : placed.error().in(file.string());
}

}  // namespace pdr::app
