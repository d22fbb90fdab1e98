#pragma once
/// What one file says about itself, up to but not including its pixels. Plain data; the toolkit stays in the .cpp.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "dicom/go_on.h"
#include "dicom/series.h"

namespace pdr::dicom {

/// How a stored pixel becomes a number.
struct PixelFormat {
    int bitsAllocated = 0, bitsStored = 0, highBit = 0;
    bool isSigned = false;
    int samplesPerPixel = 1;
    std::string photometric;
};

/// How that number becomes Hounsfield units, or says "nothing was measured here".
struct ValueMeaning {
    std::optional<double> slope, intercept;         ///< HU = stored * slope + intercept
    std::string unit;                               ///< RescaleType: "HU", or empty where nothing is said
    bool rescaleIsBroken = false;                   ///< stated, but not a finite number, or a slope of 0
    std::optional<int> paddingValue, paddingLimit;  ///< the 16 bits as written, read as unsigned [0, 65535]
};

struct SliceHeader {
    std::filesystem::path file;
    PatientFacts patient;
    StudyFacts study;
    SeriesFacts series;

    std::string sopInstanceUid;
    std::string frameOfReferenceUid;
    std::string imageType;  ///< values joined by a backslash: "ORIGINAL\PRIMARY\AXIAL"
    std::optional<int> instanceNumber;
    bool isLossy = false;              ///< the pixels went through a lossy coding, now or earlier
    std::optional<double> lossyRatio;  ///< by how much that made them smaller, where it is said

    bool hasMetaHeader = false;
    std::string transferSyntaxUid;  ///< as stated, or as found where nothing is stated
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data as it lies in the file; 0 = no pixels
    int columns = 0, rows = 0, frames = 1;
    PixelFormat format;
    ValueMeaning meaning;

    std::optional<dvec3> position;         ///< ImagePositionPatient [mm], LPS
    std::optional<dvec3> rowDirection;     ///< the way a row runs (ImageOrientationPatient 0..2)
    std::optional<dvec3> columnDirection;  ///< the way a column runs (3..5)
    std::optional<dvec2> spacingMm;        ///< x: between columns, y: between rows
};

SliceIdentity identityOf(const SliceHeader& header);

struct HeaderRead {
    enum class Kind {
        notDicom,   ///< something else
        directory,  ///< a DICOMDIR: lists files, is no image
        damaged,    ///< DICOM, but not to be used; `damage` says why; `header` holds what could be read
        object,     ///< an image or another DICOM object
    };
    Kind kind = Kind::notDicom;
    SliceHeader header;
    Text damage;  ///< a phrase ("it ends inside the compressed picture")
};

/// Never throws for what is in the file, and never prints it. `goOn`: see checkStructure.
HeaderRead readSliceHeader(const std::filesystem::path& file, const GoOn& goOn = always);

}  // namespace pdr::dicom
