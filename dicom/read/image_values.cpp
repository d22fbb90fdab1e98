#include "dicom/read/image_values.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "dicom/read/item_values.h"

namespace pdr::dicom {

namespace {

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

/// Fills the table of values (PS3.3, C.11.1.1) and their unit; none if it holds another number of them than it states.
void readTable(DcmItem& item, ValueMeaning& meaning) {
    constexpr unsigned long kMost = 1 << 16;  // stated as 0
    long int stated = 0, first = 0;
    const Uint16* values = nullptr;
    unsigned long count = 0;
    if (item.findAndGetLongInt(DCM_LUTDescriptor, stated, 0).bad() ||
        item.findAndGetLongInt(DCM_LUTDescriptor, first, 1).bad() ||
        item.findAndGetUint16Array(DCM_LUTData, values, &count).bad() || !values || count == 0 || count > kMost ||
        count % kMost != static_cast<unsigned long>(stated) % kMost)
        return;
    meaning.table = std::make_shared<const ValueTable>(ValueTable{int(first), {values, values + count}});
    meaning.unit = text(item, DCM_ModalityLUTType);
}

}  // namespace

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

void readRescale(DcmItem& item, ValueMeaning& meaning) {
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
    meaning.table.reset();
    DcmItem* table = nullptr;
    if (meaning.isByTable && item.findAndGetSequenceItem(DCM_ModalityLUTSequence, table, 0).good())
        readTable(*table, meaning);
}

void readUnitName(DcmItem& item, ValueMeaning& meaning) {
    DcmItem *map = nullptr, *code = nullptr;
    if (item.findAndGetSequenceItem(DCM_RealWorldValueMappingSequence, map, 0).bad() ||
        map->findAndGetSequenceItem(DCM_MeasurementUnitsCodeSequence, code, 0).bad())
        return;
    Float64 slope = 0, intercept = 0;
    const bool isLinear = map->findAndGetFloat64(DCM_RealWorldValueSlope, slope).good() &&
                          map->findAndGetFloat64(DCM_RealWorldValueIntercept, intercept).good();
    const auto isClose = [](double a, double b) {
        return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
    };
    const std::string unit = text(*code, DCM_CodeValue);
    constexpr const char* kNone = "1";  // of a number without a unit, in UCUM
    if (isLinear && isClose(slope, meaning.slope.value_or(1)) && isClose(intercept, meaning.intercept.value_or(0)) &&
        unit != kNone)
        meaning.name = unit;
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
        return {{}, phrase("the grey window in the files is left out: no window is %1 wide", numberOf(window.width))};
    return {window, {}};
}

}  // namespace pdr::dicom
