#pragma once
/// Writes small CT slices for tests, right or deliberately wrong.

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/base/portable.h"

namespace pdr::test {

/// Content of a slice file before `change` alters it: a valid 16-bit CT slice, axial, pixels of 1 mm.
struct SliceFile {
    ivec2 size{4, 3};
    dvec3 position{0, 0, 0};
    std::vector<std::uint16_t> raw;  ///< empty: the numbers 0, 1, 2, ...
    bool isSigned = true;
    int bitsStored = 16;
    std::string seriesUid = "1.2.3.1";
    std::function<void(DcmDataset&)> change;
};

inline void writeSliceFile(const std::filesystem::path& file, const SliceFile& slice) {
    DcmFileFormat content;
    DcmDataset& data = *content.getDataset();
    char uid[100], position[100];
    data.putAndInsertString(DCM_SOPClassUID, UID_CTImageStorage);
    data.putAndInsertString(DCM_SOPInstanceUID, dcmGenerateUniqueIdentifier(uid));
    data.putAndInsertString(DCM_StudyInstanceUID, "1.2.3");
    data.putAndInsertString(DCM_SeriesInstanceUID, slice.seriesUid.c_str());
    data.putAndInsertString(DCM_Modality, "CT");
    data.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\AXIAL");
    std::snprintf(position, sizeof position, "%.6g\\%.6g\\%.6g", slice.position.x, slice.position.y, slice.position.z);
    data.putAndInsertString(DCM_ImagePositionPatient, position);
    data.putAndInsertString(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
    data.putAndInsertString(DCM_PixelSpacing, "1\\1");
    data.putAndInsertString(DCM_RescaleSlope, "1");
    data.putAndInsertString(DCM_RescaleIntercept, "0");
    data.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    data.putAndInsertUint16(DCM_Columns, Uint16(slice.size.x));
    data.putAndInsertUint16(DCM_Rows, Uint16(slice.size.y));
    data.putAndInsertUint16(DCM_BitsAllocated, 16);
    data.putAndInsertUint16(DCM_BitsStored, Uint16(slice.bitsStored));
    data.putAndInsertUint16(DCM_HighBit, Uint16(slice.bitsStored - 1));
    data.putAndInsertUint16(DCM_PixelRepresentation, slice.isSigned ? 1 : 0);
    std::vector<std::uint16_t> raw = slice.raw;
    for (std::size_t i = raw.size(); i < std::size_t(slice.size.x * slice.size.y); ++i)
        raw.push_back(std::uint16_t(i));
    data.putAndInsertUint16Array(DCM_PixelData, raw.data(), static_cast<unsigned long>(raw.size()));
    if (slice.change)
        slice.change(data);
    content.saveFile(file.c_str(), EXS_LittleEndianExplicit);
}

}  // namespace pdr::test
