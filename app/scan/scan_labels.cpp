#include "app/scan/scan_labels.h"

#include "render/volume/file/label_file.h"

namespace pdr::app {

Result<LabelMap> readScanLabels(const std::filesystem::path& file, const VolumeGeometry& scan, const dicom::Series*,
                                Resampling resampling, const Progress& progress) {
    Result<LabelMap> map = readLabelFile(file, progress);
    if (!map)
        return map;
    Result<LabelMap> placed = labelsOn(scan, *std::move(map), resampling);
    return placed ? std::move(placed) : placed.error().in(file.string());
}

}  // namespace pdr::app
