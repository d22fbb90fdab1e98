#include "dicom/read/slice_header.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "dicom/read/character_set.h"
#include "dicom/read/codecs.h"
#include "dicom/read/file_structure.h"
#include "dicom/read/frames.h"
#include "dicom/read/image_values.h"
#include "dicom/read/item_values.h"
#include "dicom/read/parsed_object.h"
#include "dicom/read/phase_values.h"
#include "dicom/read/refusal.h"

namespace pdr::dicom {

namespace {

/// Returns a person's name without the separators that may stand at its end for absent components.
std::string personName(DcmItem& item, const DcmTagKey& tag) {
    std::string name = text(item, tag);
    name.resize(name.find_last_not_of("=^ ") + 1);
    return name;
}

void readFacts(DcmItem& item, SliceHeader& header) {
    const std::string characterSet = text(item, DCM_SpecificCharacterSet);
    const bool isUtf8 = item.convertToUTF8().good();
    header.patient = {personName(item, DCM_PatientName), text(item, DCM_PatientID), text(item, DCM_PatientBirthDate),
                      text(item, DCM_PatientSex)};
    header.study = {text(item, DCM_StudyInstanceUID), text(item, DCM_StudyDate), text(item, DCM_StudyDescription)};
    header.series = {text(item, DCM_SeriesInstanceUID), text(item, DCM_Modality), text(item, DCM_SeriesDescription),
                     text(item, DCM_SeriesDate), integerValue(item, DCM_SeriesNumber, 0)};
    if (isUtf8)
        return;
    for (std::string* value :
         {&header.patient.name, &header.patient.id, &header.study.description, &header.series.description})
        *value = readable(*value, characterSet);
}

/// Returns the 16 bits of a padding value, which may be written US or SS, whatever the pixels are.
std::optional<int> sixteenBits(DcmItem& item, const DcmTagKey& tag) {
    Uint16 asUnsigned = 0;
    Sint16 asSigned = 0;
    if (item.findAndGetUint16(tag, asUnsigned).good())
        return int(asUnsigned);
    if (item.findAndGetSint16(tag, asSigned).good())
        return int(std::uint16_t(asSigned));
    return {};
}

void readPixelFormat(DcmItem& item, SliceHeader& header) {
    header.realBits = item.tagExists(DCM_FloatPixelData) ? 32 : item.tagExists(DCM_DoubleFloatPixelData) ? 64 : 0;
    header.columns = shortValue(item, DCM_Columns, 0);
    header.rows = shortValue(item, DCM_Rows, 0);
    header.frames = integerValue(item, DCM_NumberOfFrames, 1);
    header.concatenation = {text(item, DCM_ConcatenationUID), shortValue(item, DCM_InConcatenationNumber, 0),
                            shortValue(item, DCM_InConcatenationTotalNumber, 0)};
    header.hasFrameGroups = item.tagExists(DCM_PerFrameFunctionalGroupsSequence);
    const int bits = shortValue(item, DCM_BitsAllocated, 0);
    const int stored = shortValue(item, DCM_BitsStored, bits);
    header.format = {bits,
                     stored,
                     shortValue(item, DCM_HighBit, stored - 1),
                     shortValue(item, DCM_PixelRepresentation, 0) == 1,
                     shortValue(item, DCM_SamplesPerPixel, 1),
                     text(item, DCM_PhotometricInterpretation)};
}

/// Returns the padding value of floating-point pixels, of either width.
std::optional<double> realPadding(DcmItem& item) {
    Float32 single = 0;
    Float64 twice = 0;
    if (item.findAndGetFloat32(DCM_FloatPixelPaddingValue, single).good())
        return double(single);
    if (item.findAndGetFloat64(DCM_DoubleFloatPixelPaddingValue, twice).good())
        return twice;
    return {};
}

void readMeaning(DcmItem& item, ValueMeaning& meaning) {
    readRescale(item, meaning);
    meaning.name = text(item, DCM_Units);  // of PET (PS3.3, C.8.9.1)
    readUnitName(item, meaning);
    meaning.realPadding = realPadding(item);
    meaning.paddingValue = sixteenBits(item, DCM_PixelPaddingValue);
    meaning.paddingLimit = sixteenBits(item, DCM_PixelPaddingRangeLimit);
}

std::optional<int> countIn(DcmItem& item, const DcmTagKey& tag) {
    const auto stated = numbers<1>(item, tag);
    return stated ? std::optional(int(std::clamp((*stated)[0], -1e9, 1e9))) : std::nullopt;
}

/// Fills `read` from the elements before the pixels. False if the toolkit cannot parse them, or `goOn` stopped it.
bool parseHeader(const NamedBytes& object, const GoOn& goOn, HeaderRead& read, bool& isDirectory) {
    SliceHeader& header = read.header;
    DcmFileFormat content;
    const bool parsed = parseObject(object, header, Extent::header, content, goOn);
    DcmItem& item = *content.getDataset();
    isDirectory = text(*content.getMetaInfo(), DCM_MediaStorageSOPClassUID) == UID_MediaStorageDirectoryStorage;
    header.imageType = text(item, DCM_ImageType);
    header.sopClassUid = text(item, DCM_SOPClassUID);
    header.sopInstanceUid = text(item, DCM_SOPInstanceUID);
    header.frameOfReferenceUid = text(item, DCM_FrameOfReferenceUID);
    header.instanceNumber = countIn(item, DCM_InstanceNumber);
    header.acquisitionImages = countIn(item, DCM_ImagesInAcquisition);
    const std::string stated = text(item, DCM_LossyImageCompression);
    header.isLossy = codingIsLossy(header.transferSyntaxUid) || stated == "01";
    header.mayBeLossy = codingMayLose(header.transferSyntaxUid) && stated.empty();
    if (const auto ratio = numbers<1>(item, DCM_LossyImageCompressionRatio))
        header.lossyRatio = (*ratio)[0];
    header.phaseValues = phaseValues(item);
    readFacts(item, header);
    readPixelFormat(item, header);
    readMeaning(item, header.meaning);
    header.window = readWindow(item);
    readPlane(item, header);
    if (parsed && header.hasFrameGroups && !refusePixels(header))
        read.frames = readFrames(item, header);
    return parsed;
}

}  // namespace

SliceIdentity identityOf(const SliceHeader& header) {
    return {header.patient,     header.study.uid,      header.series.uid,
            header.sopClassUid, header.sopInstanceUid, header.frameOfReferenceUid,
            header.position,    header.rowDirection,   header.columnDirection,
            header.spacingMm};
}

HeaderRead readSliceHeader(const NamedBytes& object, const GoOn& goOn) {
    prepareToolkit();
    HeaderRead read;
    SliceHeader& header = read.header;
    header.file = object.name;
    const FileStructure structure = checkStructure(object, goOn);
    if (!structure.isDicom)
        return read;
    header.hasMetaHeader = structure.hasMetaHeader;
    header.transferSyntaxUid = structure.transferSyntaxUid;
    header.pixelBytes = structure.pixelBytes;
    header.pixelsAt = structure.pixelsAt;
    header.hasPixelsTwice = structure.hasPixelsTwice;
    read.damage = structure.damage;
    read.kind = structure.damage.empty() ? HeaderRead::Kind::object : HeaderRead::Kind::damaged;
    if (!structure.damage.empty() && !structure.reachesPixels)
        return read;
    bool isDirectory = false;
    const bool parsed = parseHeader(object, goOn, read, isDirectory);
    if (isDirectory) {
        read.kind = HeaderRead::Kind::directory;
    } else if (!parsed && structure.damage.empty()) {
        read.kind = HeaderRead::Kind::damaged;
        read.damage = phrase("its header cannot be read");
    } else if (!read.frames.empty() && int(read.frames.size()) != header.frames && structure.damage.empty()) {
        read.kind = HeaderRead::Kind::damaged;
        read.damage = phrase("it states %1 frames, and describes another number of them", header.frames);
    }
    return read;
}

}  // namespace pdr::dicom
