#include "dicom/read/slice_header.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "dicom/read/character_set.h"
#include "dicom/read/codecs.h"
#include "dicom/read/file_structure.h"
#include "dicom/read/parsed_object.h"

namespace pdr::dicom {

namespace {

constexpr std::size_t kLongestText = 512;

/// Returns the value of a decimal string that is a number from end to end: "1,5" must not pass as 1.
std::optional<double> number(std::string_view written) {
    while (!written.empty() && (written.back() == ' ' || written.back() == '\0'))
        written.remove_suffix(1);
    while (!written.empty() && (written.front() == ' ' || written.front() == '+'))
        written.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(written.data(), written.data() + written.size(), value);
    if (failure != std::errc() || end != written.data() + written.size() || !std::isfinite(value))
        return {};
    return value;
}

/// Returns the values of a decimal string; none if it is absent, shorter or not all numbers.
template <int Count>
std::optional<std::array<double, Count>> numbers(DcmItem& item, const DcmTagKey& tag) {
    std::array<double, Count> values;
    for (int i = 0; i < Count; ++i) {
        OFString written;
        if (item.findAndGetOFString(tag, written, static_cast<unsigned long>(i)).bad())
            return {};
        const std::optional<double> value = number({written.c_str(), written.size()});
        if (!value)
            return {};
        values[i] = *value;
    }
    return values;
}

int shortValue(DcmItem& item, const DcmTagKey& tag, int absent) {
    Uint16 value = 0;
    return item.findAndGetUint16(tag, value).good() ? int(value) : absent;
}

int integerValue(DcmItem& item, const DcmTagKey& tag, int absent) {
    Sint32 value = 0;
    return item.findAndGetSint32(tag, value).good() ? int(value) : absent;
}

std::string text(DcmItem& item, const DcmTagKey& tag) {
    OFString value;
    item.findAndGetOFStringArray(tag, value);
    std::string result(value.c_str(), std::min(value.size(), kLongestText));
    // A cut may fall into the middle of a UTF-8 character.
    while (result.size() == kLongestText && (result.back() & 0xC0) == 0x80)
        result.pop_back();
    const auto end = result.find_last_not_of(" \0");
    result.resize(end == std::string::npos ? 0 : end + 1);
    return result;
}

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
    header.hasFloatPixels = item.tagExists(DCM_FloatPixelData) || item.tagExists(DCM_DoubleFloatPixelData);
    header.columns = shortValue(item, DCM_Columns, 0);
    header.rows = shortValue(item, DCM_Rows, 0);
    header.frames = integerValue(item, DCM_NumberOfFrames, 1);
    const int bits = shortValue(item, DCM_BitsAllocated, 0);
    const int stored = shortValue(item, DCM_BitsStored, bits);
    header.format = {bits,
                     stored,
                     shortValue(item, DCM_HighBit, stored - 1),
                     shortValue(item, DCM_PixelRepresentation, 0) == 1,
                     shortValue(item, DCM_SamplesPerPixel, 1),
                     text(item, DCM_PhotometricInterpretation)};
}

void readMeaning(DcmItem& item, ValueMeaning& meaning) {
    const auto slope = numbers<1>(item, DCM_RescaleSlope);
    const auto intercept = numbers<1>(item, DCM_RescaleIntercept);
    if (slope)
        meaning.slope = (*slope)[0];
    if (intercept)
        meaning.intercept = (*intercept)[0];
    meaning.rescaleIsBroken = (!slope && item.tagExistsWithValue(DCM_RescaleSlope)) || meaning.slope == 0.0 ||
                              (!intercept && item.tagExistsWithValue(DCM_RescaleIntercept));
    meaning.unit = text(item, DCM_RescaleType);
    meaning.isByTable = item.tagExists(DCM_ModalityLUTSequence);
    meaning.paddingValue = sixteenBits(item, DCM_PixelPaddingValue);
    meaning.paddingLimit = sixteenBits(item, DCM_PixelPaddingRangeLimit);
}

/// Returns the VOI LUT Function of that name; LINEAR is meant where none is stated.
std::optional<VoiFunction> voiFunction(const std::string& name) {
    if (name.empty() || name == "LINEAR")
        return VoiFunction::linear;
    if (name == "LINEAR_EXACT")
        return VoiFunction::linearExact;
    if (name == "SIGMOID")
        return VoiFunction::sigmoid;
    return {};
}

StatedWindow readWindow(DcmItem& item) {
    if (!item.tagExistsWithValue(DCM_WindowCenter) && !item.tagExistsWithValue(DCM_WindowWidth))
        return {};
    const auto centre = numbers<1>(item, DCM_WindowCenter), width = numbers<1>(item, DCM_WindowWidth);
    if (!centre || !width)
        return {{}, phrase("the grey window in the files is left out: its centre or its width is no number")};
    const std::string name = text(item, DCM_VOILUTFunction);
    const auto function = voiFunction(name);
    if (!function)
        return {{}, phrase("the grey window in the files is left out: its function \"%1\" is not known", name)};
    const GreyWindow window{(*centre)[0], (*width)[0], *function};
    if (!window.valid())
        return {{},
                phrase("the grey window in the files is left out: no window is %1 HU wide", numberOf(window.width))};
    return {window, {}};
}

void readPlane(DcmItem& item, SliceHeader& header) {
    if (const auto p = numbers<3>(item, DCM_ImagePositionPatient))
        header.position = dvec3((*p)[0], (*p)[1], (*p)[2]);
    if (const auto o = numbers<6>(item, DCM_ImageOrientationPatient)) {
        header.rowDirection = dvec3((*o)[0], (*o)[1], (*o)[2]);
        header.columnDirection = dvec3((*o)[3], (*o)[4], (*o)[5]);
    }
    // PixelSpacing names the distance between rows first.
    if (const auto s = numbers<2>(item, DCM_PixelSpacing))
        header.spacingMm = dvec2((*s)[1], (*s)[0]);
}

/// Fills `header` from the elements before the pixels. False if the toolkit cannot parse them.
bool parseHeader(const NamedBytes& object, SliceHeader& header, bool& isDirectory) {
    DcmFileFormat content;
    const bool parsed = parseObject(object, header, Extent::header, content);
    DcmItem& item = *content.getDataset();
    isDirectory = text(*content.getMetaInfo(), DCM_MediaStorageSOPClassUID) == UID_MediaStorageDirectoryStorage;
    header.imageType = text(item, DCM_ImageType);
    header.sopClassUid = text(item, DCM_SOPClassUID);
    header.sopInstanceUid = text(item, DCM_SOPInstanceUID);
    header.frameOfReferenceUid = text(item, DCM_FrameOfReferenceUID);
    if (const auto instance = numbers<1>(item, DCM_InstanceNumber))
        header.instanceNumber = int(std::clamp((*instance)[0], -1e9, 1e9));
    const std::string stated = text(item, DCM_LossyImageCompression);
    header.isLossy = codingIsLossy(header.transferSyntaxUid) || stated == "01";
    header.mayBeLossy = codingMayLose(header.transferSyntaxUid) && stated.empty();
    if (const auto ratio = numbers<1>(item, DCM_LossyImageCompressionRatio))
        header.lossyRatio = (*ratio)[0];
    const DcmTagKey phaseTags[kPhaseKeys]{DCM_TemporalPositionIdentifier,
                                          DCM_NominalPercentageOfCardiacPhase,
                                          DCM_TriggerTime,
                                          DCM_KVP,
                                          DCM_AcquisitionNumber,
                                          DCM_AcquisitionTime,
                                          DCM_ContentTime,
                                          DCM_ImageType};
    std::ranges::transform(phaseTags, header.phaseKeys.begin(), [&](const DcmTagKey& tag) { return text(item, tag); });
    readFacts(item, header);
    readPixelFormat(item, header);
    readMeaning(item, header.meaning);
    header.window = readWindow(item);
    readPlane(item, header);
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
    read.damage = structure.damage;
    read.kind = structure.damage.empty() ? HeaderRead::Kind::object : HeaderRead::Kind::damaged;
    if (!structure.damage.empty() && !structure.reachesPixels)
        return read;
    bool isDirectory = false;
    const bool parsed = parseHeader(object, header, isDirectory);
    if (isDirectory) {
        read.kind = HeaderRead::Kind::directory;
    } else if (!parsed && structure.damage.empty()) {
        read.kind = HeaderRead::Kind::damaged;
        read.damage = phrase("its header cannot be read");
    }
    return read;
}

}  // namespace pdr::dicom
