#pragma once
/// The header of one object, or of one of its frames, up to but not including its pixels. Plain data; only the .cpp
/// uses the toolkit.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dicom/go_on.h"
#include "dicom/series.h"
#include "render/base/named_bytes.h"

namespace pdr::dicom {

/// The format of a stored pixel.
struct PixelFormat {
    int bitsAllocated = 0, bitsStored = 0, highBit = 0;
    bool isSigned = false;
    int samplesPerPixel = 1;
    std::string photometric;
};

/// Values in a table (Modality LUT Sequence) instead of a rescale.
struct ValueTable {
    int first = 0;                      ///< the stored number of the first value; smaller ones have that value, too
    std::vector<std::uint16_t> values;  ///< at least one; larger numbers have the last
};

/// The meaning of a stored number: a value, in Hounsfield units or not, or "nothing was measured here".
struct ValueMeaning {
    std::optional<double> slope, intercept;         ///< value = slope * (stored, or what the table has) + intercept
    std::string unit;                               ///< RescaleType: "HU", or empty if nothing is stated
    bool isByTable = false;                         ///< whether a table gives the values
    std::shared_ptr<const ValueTable> table;        ///< what gives them; null: nothing, or a broken table
    bool rescaleIsBroken = false;                   ///< stated, but not a finite number, or a slope of 0
    std::string quantity;                           ///< what they are instead ("RCBF, ml/100ml/s"); empty: not said
    std::string name;                               ///< unit of values that are no HU ("BQML"); empty: not said
    std::optional<double> realPadding;              ///< the padding value of floating-point pixels
    std::optional<int> paddingValue, paddingLimit;  ///< the 16 bits as written, read as unsigned [0, 65535]
};

/// What can tell images of one place apart, in the order in which it is asked.
enum class PhaseKey {
    stack,              ///< StackID, of frames only
    echoTime,           ///< EchoTime [ms]; of frames, EffectiveEchoTime
    echoNumber,         ///< EchoNumbers
    diffusion,          ///< DiffusionBValue [s/mm²], and the direction of its gradient where there is one
    temporalPosition,   ///< TemporalPositionIdentifier; of frames, TemporalPositionIndex
    cardiacPercentage,  ///< NominalPercentageOfCardiacPhase
    triggerTime,        ///< TriggerTime [ms]; of frames, NominalCardiacTriggerDelayTime
    kvp,                ///< KVP
    acquisitionNumber,  ///< AcquisitionNumber; of frames, FrameAcquisitionNumber
    acquisitionTime,    ///< AcquisitionTime; of frames, FrameAcquisitionDateTime
    contentTime,        ///< ContentTime; of frames, FrameReferenceDateTime
    imageType,          ///< ImageType, all values; of frames, FrameType
};
inline constexpr std::size_t kPhaseKeys = 12;

/// What an image states for each PhaseKey; empty: nothing.
using PhaseValues = std::array<std::string, kPhaseKeys>;

/// The place of an object among those that one multi-frame image is stored in.
struct Concatenation {
    std::string uid;          ///< empty: it is stored in one object
    int part = 0, parts = 0;  ///< number of this one, from 1, and of all; 0: not stated
};

struct SliceHeader {
    std::filesystem::path file;  ///< name of the object in its source
    PatientFacts patient;
    StudyFacts study;
    SeriesFacts series;

    std::string sopClassUid, sopInstanceUid, frameOfReferenceUid;  ///< as stated, even if malformed
    std::string imageType;  ///< values joined by a backslash: "ORIGINAL\PRIMARY\AXIAL"
    std::optional<int> instanceNumber;
    std::optional<int> acquisitionImages;  ///< how many images its acquisition made (ImagesInAcquisition)
    PhaseValues phaseValues;
    bool isLossy = false;              ///< whether the pixels went through a lossy coding, now or earlier
    bool mayBeLossy = false;           ///< whether their coding may have lost something, and nothing is stated
    std::optional<double> lossyRatio;  ///< how much smaller that made them, if it is stated

    bool hasMetaHeader = false;
    std::string transferSyntaxUid;  ///< as stated, or as found if nothing is stated
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data as it lies in the file; 0 = no pixels
    int realBits = 0;               ///< width of pixels that are floating-point numbers, 32 or 64; 0: they are none
    std::uint64_t pixelsAt = 0;  ///< where the pixel data begin, in the object or its inflated content; 0 = no pixels
    bool hasPixelsTwice = false;
    int columns = 0, rows = 0;
    int frames = 1;               ///< number of frames of the object, as stated
    int frame = 0;                ///< index of the frame that this is the header of
    bool hasFrameGroups = false;  ///< functional groups describe each frame
    Concatenation concatenation;
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
    /// A header for each frame, in the order of the file; none if no functional groups describe frames, or if what the
    /// frames share is refused (refusal.h).
    std::vector<SliceHeader> frames;
    Text damage;  ///< a phrase ("it ends inside the compressed image")
};

/// Reads the header of `object`. Never throws because of its content, and never prints it. `goOn`: see
/// checkStructure().
HeaderRead readSliceHeader(const NamedBytes& object, const GoOn& goOn = always);

}  // namespace pdr::dicom
