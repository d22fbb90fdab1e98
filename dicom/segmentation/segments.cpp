#include "dicom/segmentation/segments.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "dicom/read/character_set.h"
#include "dicom/read/frames.h"
#include "dicom/read/functional_groups.h"
#include "dicom/read/item_values.h"
#include "render/base/srgb.h"

namespace pdr::dicom {

namespace {

/// Calls use(item) for each item of a sequence.
template <class Use>
void forEachItem(DcmItem& parent, const DcmTagKey& tag, const Use& use) {
    DcmSequenceOfItems* sequence = nullptr;
    if (parent.findAndGetSequence(tag, sequence).bad())
        return;
    for (DcmObject* item = sequence->nextInContainer(nullptr); item; item = sequence->nextInContainer(item))
        use(*static_cast<DcmItem*>(item));
}

std::optional<SegmentationType> typeOf(const std::string& word) {
    if (word == "BINARY")
        return SegmentationType::binary;
    if (word == "FRACTIONAL")
        return SegmentationType::fractional;
    return word == "LABELMAP" ? std::optional(SegmentationType::labelMap) : std::nullopt;
}

std::optional<LabelColour> colourOf(DcmItem& segment) {
    std::array<std::uint16_t, 3> lab;
    for (unsigned long i = 0; i < 3; ++i)
        if (segment.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, lab[i], i).bad())
            return {};
    return fromCieLab(lab);
}

/// Returns what a segment is called: by its label, or else by what it is of.
std::string labelOf(DcmItem& segment) {
    const std::string label = text(segment, DCM_SegmentLabel);
    DcmItem* type = label.empty() ? firstItem(segment, DCM_SegmentedPropertyTypeCodeSequence) : nullptr;
    return type ? text(*type, DCM_CodeMeaning) : label;
}

int segmentOf(DcmItem& frame, DcmItem* shared) {
    DcmItem* group = FunctionalGroups{frame, shared}.find(DCM_SegmentIdentificationSequence);
    return group ? shortValue(*group, DCM_ReferencedSegmentNumber, 0) : 0;
}

}  // namespace

LabelColour fromCieLab(const std::array<std::uint16_t, 3>& lab) {
    const double l = lab[0] / 65535.0 * 100, a = lab[1] / 65535.0 * 255 - 128, b = lab[2] / 65535.0 * 255 - 128;
    const auto linear = [](double f) {
        return f > 6.0 / 29 ? f * f * f : 3 * (6.0 / 29) * (6.0 / 29) * (f - 4.0 / 29);
    };
    const double y = (l + 16) / 116;
    const dvec3 xyz = dvec3(linear(y + a / 500), linear(y), linear(y - b / 200)) * dvec3(0.95047, 1, 1.08883);
    const dmat3 rgbFromXyz(dvec3(3.2404542, -0.9692660, 0.0556434), dvec3(-1.5371385, 1.8760108, -0.2040259),
                           dvec3(-0.4985314, 0.0415560, 1.0572252));
    const dvec3 rgb = rgbFromXyz * xyz;
    LabelColour colour;
    for (int i = 0; i < 3; ++i)
        colour[std::size_t(i)] = std::uint8_t(std::lround(255 * srgbFromLinear(std::clamp(rgb[i], 0.0, 1.0))));
    return colour;
}

Segments readSegments(DcmItem& data, const SliceHeader& header) {
    Segments segments;
    const std::string characterSet = text(data, DCM_SpecificCharacterSet);
    const bool isUtf8 = data.convertToUTF8().good();
    segments.type = typeOf(text(data, DCM_SegmentationType));
    segments.mostFraction = shortValue(data, DCM_MaximumFractionalValue, 255);
    forEachItem(data, DCM_SegmentSequence, [&](DcmItem& item) {
        const std::string label = labelOf(item);
        segments.byNumber[shortValue(item, DCM_SegmentNumber, 0)] = {isUtf8 ? label : readable(label, characterSet),
                                                                     colourOf(item)};
    });
    forEachItem(data, DCM_ReferencedSeriesSequence,
                [&](DcmItem& item) { segments.seriesUids.push_back(text(item, DCM_SeriesInstanceUID)); });
    segments.frames = readFrames(data, header);
    DcmItem* shared = firstItem(data, DCM_SharedFunctionalGroupsSequence);
    forEachItem(data, DCM_PerFrameFunctionalGroupsSequence,
                [&](DcmItem& item) { segments.segmentOfFrame.push_back(segmentOf(item, shared)); });
    return segments;
}

}  // namespace pdr::dicom
