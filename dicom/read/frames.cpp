#include "dicom/read/frames.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <set>
#include <string>

#include "dicom/read/functional_groups.h"
#include "dicom/read/image_values.h"
#include "dicom/read/item_values.h"
#include "dicom/read/phase_values.h"

namespace pdr::dicom {

namespace {

/// Returns the fourth value of a frame type ("RCBF") if it stands for a quantity that is not measured in HU.
std::string quantityOfType(const std::string& frameType) {
    static const std::set<std::string> kStillHu{"",     "NONE",   "MINIMUM",   "MAXIMUM",
                                                "MEAN", "MEDIAN", "RESAMPLED", "FILTERED"};
    std::size_t start = 0;
    for (int value = 1; value < 4; ++value) {
        const std::size_t separator = frameType.find('\\', start);
        if (separator == std::string::npos)
            return {};
        start = separator + 1;
    }
    const std::string contrast = frameType.substr(start, frameType.find('\\', start) - start);
    return kStillHu.contains(contrast) ? std::string() : contrast;
}

/// Returns the unit of the real-world values; empty if none is stated, or Hounsfield units are.
std::string mappedUnit(const FunctionalGroups& groups) {
    DcmItem* map = groups.find(DCM_RealWorldValueMappingSequence);
    DcmItem* unit = map ? firstItem(*map, DCM_MeasurementUnitsCodeSequence) : nullptr;
    const std::string code = unit ? text(*unit, DCM_CodeValue) : std::string();
    return code == "[hnsf'U]" || code == "HU" ? std::string() : code;
}

/// Returns what the values are where the frame says that they are no HU: "RCBF, ml/100ml/s".
std::string quantityOf(const FunctionalGroups& groups, const std::string& frameType) {
    const std::string type = quantityOfType(frameType), unit = mappedUnit(groups);
    return type + (type.empty() || unit.empty() ? "" : ", ") + unit;
}

SliceHeader frameOf(const FunctionalGroups& groups, const SliceHeader& object, int index) {
    SliceHeader frame = object;
    frame.frame = index;
    frame.position.reset();
    for (const DcmTagKey& place : {DCM_PlanePositionSequence, DCM_PlaneOrientationSequence, DCM_PixelMeasuresSequence})
        if (DcmItem* group = groups.find(place))
            readPlane(*group, frame);
    if (DcmItem* group = groups.find(DCM_PixelValueTransformationSequence))
        readRescale(*group, frame.meaning);
    if (DcmItem* group = groups.holderOf(DCM_RealWorldValueMappingSequence))
        readUnitName(*group, frame.meaning);
    if (DcmItem* group = groups.find(DCM_FrameVOILUTSequence))
        frame.window = readWindow(*group);
    readPhaseValues(groups, frame.phaseValues);
    frame.meaning.quantity = quantityOf(groups, frame.phaseValues[std::size_t(PhaseKey::imageType)]);
    return frame;
}

}  // namespace

std::vector<SliceHeader> readFrames(DcmItem& data, const SliceHeader& object) {
    std::vector<SliceHeader> frames;
    DcmSequenceOfItems* described = nullptr;
    if (data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, described).bad())
        return frames;
    DcmItem* shared = firstItem(data, DCM_SharedFunctionalGroupsSequence);
    frames.reserve(std::min<std::size_t>(described->card(), std::size_t(object.frames) + 1));
    DcmObject* item = nullptr;
    while (int(frames.size()) <= object.frames && (item = described->nextInContainer(item)))
        frames.push_back(frameOf({*static_cast<DcmItem*>(item), shared}, object, int(frames.size())));
    return frames;
}

}  // namespace pdr::dicom
