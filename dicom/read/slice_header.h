#pragma once
/// The header of one object, up to but not including its pixels. Plain data; only the .cpp uses the toolkit.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "dicom/go_on.h"
#include "dicom/named_bytes.h"
#include "dicom/series.h"

namespace pdr::dicom {

/// The format of a stored pixel.
struct PixelFormat {
    int bitsAllocated = 0, bitsStored = 0, highBit = 0;
    bool isSigned = false;
    int samplesPerPixel = 1;
    std::string photometric;
};

/// The meaning of a stored number: Hounsfield units, or "nothing was measured here".
struct ValueMeaning {
    std::optional<double> slope, intercept;         ///< HU = stored * slope + intercept
    std::string unit;                               ///< RescaleType: "HU", or empty if nothing is stated
    bool isByTable = false;                         ///< a table (Modality LUT Sequence) gives the values
    bool rescaleIsBroken = false;                   ///< stated, but not a finite number, or a slope of 0
    std::optional<int> paddingValue, paddingLimit;  ///< the 16 bits as written, read as unsigned [0, 65535]
};

/// What can tell images of one place apart, in the order in which it is asked.
enum class PhaseKey {
    temporalPosition,   ///< TemporalPositionIdentifier
    cardiacPercentage,  ///< NominalPercentageOfCardiacPhase
    triggerTime,        ///< TriggerTime [ms]
    kvp,                ///< KVP
    acquisitionNumber,  ///< AcquisitionNumber
    acquisitionTime,    ///< AcquisitionTime
    contentTime,        ///< ContentTime
    imageType,          ///< ImageType, all values
};
inline constexpr std::size_t kPhaseKeys = 8;

struct SliceHeader {
    std::filesystem::path file;  ///< name of the object in its source
    PatientFacts patient;
    StudyFacts study;
    SeriesFacts series;

    std::string sopClassUid, sopInstanceUid, frameOfReferenceUid;  ///< as stated, even if malformed
    std::string imageType;  ///< values joined by a backslash: "ORIGINAL\PRIMARY\AXIAL"
    std::optional<int> instanceNumber;
    std::array<std::string, kPhaseKeys> phaseKeys;  ///< by PhaseKey; empty: not stated
    bool isLossy = false;                           ///< whether the pixels went through a lossy coding, now or earlier
    bool mayBeLossy = false;           ///< whether their coding may have lost something, and nothing is stated
    std::optional<double> lossyRatio;  ///< how much smaller that made them, if it is stated

    bool hasMetaHeader = false;
    std::string transferSyntaxUid;  ///< as stated, or as found if nothing is stated
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data as it lies in the file; 0 = no pixels
    bool hasFloatPixels = false;    ///< the pixels are floating-point numbers, and pixelBytes is 0
    int columns = 0, rows = 0, frames = 1;
    PixelFormat format;
    ValueMeaning meaning;
    StatedWindow window;  ///< the first, if several are stated

    std::optional<dvec3> position;         ///< ImagePositionPatient [mm], LPS
    std::optional<dvec3> rowDirection;     ///< direction of a row (ImageOrientationPatient 0..2)
    std::optional<dvec3> columnDirection;  ///< direction of a column (ImageOrientationPatient 3..5)
    std::optional<dvec2> spacingMm;        ///< x: between columns, y: between rows
};

SliceIdentity identityOf(const SliceHeader& header);

struct HeaderRead {
    enum class Kind {
        notDicom,   ///< not DICOM
        directory,  ///< a DICOMDIR: it lists files and is no image
        damaged,    ///< DICOM, but unusable; `damage` says why; `header` holds what could be read
        object,     ///< an image or another DICOM object
    };
    Kind kind = Kind::notDicom;
    SliceHeader header;
    Text damage;  ///< a phrase ("it ends inside the compressed image")
};

/// Reads the header of `object`. Never throws because of its content, and never prints it. `goOn`: see
/// checkStructure().
HeaderRead readSliceHeader(const NamedBytes& object, const GoOn& goOn = always);

}  // namespace pdr::dicom
