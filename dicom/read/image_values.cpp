#include "dicom/read/image_values.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

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

}  // namespace pdr::dicom
