#include "app/scan/scan_labels.h"

#include "dicom/segmentation/segmentation.h"
#include "render/volume/file/label_file.h"

namespace pdr::app {

Result<LabelMap> readScanLabels(const std::filesystem::path& file, const VolumeGeometry& scan,
                                const dicom::Series* series, Resampling resampling, const Progress& progress) {
    static const dicom::Series kNone;  // of a raw file nothing is known that a segmentation could contradict
    Result<LabelMap> map = isGridFile(file) ? readLabelFile(file, progress)
                                            : dicom::readSegmentation({file}, series ? *series : kNone, scan, progress);
    if (!map)
        return map;
    Result<LabelMap> placed = labelsOn(scan, *std::move(map), resampling);
    return placed ? std::move(placed) : placed.error().in(file.string());
}

}  // namespace pdr::app
