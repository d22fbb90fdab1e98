#include "dicom/read/frames.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "dicom/read/image_values.h"
#include "dicom/read/item_values.h"

namespace pdr::dicom {

namespace {

/// Where a frame says what tells it from others of its place.
struct PhaseTag {
    PhaseKey key;
    DcmTagKey group, tag;  ///< in a functional group
    DcmTagKey converted;   ///< among the unassigned attributes of a legacy converted image
};

const std::array<PhaseTag, kPhaseKeys> kPhaseTags{{
    {PhaseKey::stack, DCM_FrameContentSequence, DCM_StackID, DCM_StackID},
    {PhaseKey::temporalPosition, DCM_FrameContentSequence, DCM_TemporalPositionIndex, DCM_TemporalPositionIdentifier},
    {PhaseKey::cardiacPercentage, DCM_CardiacSynchronizationSequence, DCM_NominalPercentageOfCardiacPhase,
     DCM_NominalPercentageOfCardiacPhase},
    {PhaseKey::triggerTime, DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime, DCM_TriggerTime},
    {PhaseKey::kvp, DCM_CTXRayDetailsSequence, DCM_KVP, DCM_KVP},
    {PhaseKey::acquisitionNumber, DCM_FrameContentSequence, DCM_FrameAcquisitionNumber, DCM_AcquisitionNumber},
    {PhaseKey::acquisitionTime, DCM_FrameContentSequence, DCM_FrameAcquisitionDateTime, DCM_AcquisitionTime},
    {PhaseKey::contentTime, DCM_FrameContentSequence, DCM_FrameReferenceDateTime, DCM_ContentTime},
    {PhaseKey::imageType, DCM_CTImageFrameTypeSequence, DCM_FrameType, DCM_ImageType},
}};

DcmItem* firstItem(DcmItem& parent, const DcmTagKey& sequence) {
    DcmItem* item = nullptr;
    return parent.findAndGetSequenceItem(sequence, item, 0).good() ? item : nullptr;
}

/// The groups of one frame, and those that all frames share.
struct Groups {
    DcmItem& own;
    DcmItem* shared;  ///< null: none are shared

    /// Returns what has the group; null: neither the frame nor all of them have it.
    DcmItem* holderOf(const DcmTagKey& group) const {
        return firstItem(own, group) ? &own : shared && firstItem(*shared, group) ? shared : nullptr;
    }
    /// Returns the first item of a group; null: neither the frame nor all of them have it.
    DcmItem* find(const DcmTagKey& group) const {
        DcmItem* item = firstItem(own, group);
        return item || !shared ? item : firstItem(*shared, group);
    }
};

/// Returns a number without superfluous digits, or a text as it is; empty if it is not there.
std::string valueOf(DcmItem& item, const DcmTagKey& tag) {
    Float64 value = 0;
    return item.findAndGetFloat64(tag, value).good() ? std::string(numberOf(value, 6)) : text(item, tag);
}

std::string phaseValue(const Groups& groups, const PhaseTag& place) {
    if (DcmItem* group = groups.find(place.group))
        if (std::string value = valueOf(*group, place.tag); !value.empty())
            return value;
    DcmItem* own = firstItem(groups.own, DCM_UnassignedPerFrameConvertedAttributesSequence);
    DcmItem* shared =
        groups.shared ? firstItem(*groups.shared, DCM_UnassignedSharedConvertedAttributesSequence) : nullptr;
    for (DcmItem* item : {own, shared})
        if (std::string value = item ? valueOf(*item, place.converted) : ""; !value.empty())
            return value;
    return {};
}

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
std::string mappedUnit(const Groups& groups) {
    DcmItem* map = groups.find(DCM_RealWorldValueMappingSequence);
    DcmItem* unit = map ? firstItem(*map, DCM_MeasurementUnitsCodeSequence) : nullptr;
    const std::string code = unit ? text(*unit, DCM_CodeValue) : std::string();
    return code == "[hnsf'U]" || code == "HU" ? std::string() : code;
}

/// Returns what the values are where the frame says that they are no HU: "RCBF, ml/100ml/s".
std::string quantityOf(const Groups& groups, const std::string& frameType) {
    const std::string type = quantityOfType(frameType), unit = mappedUnit(groups);
    return type + (type.empty() || unit.empty() ? "" : ", ") + unit;
}

SliceHeader frameOf(const Groups& groups, const SliceHeader& object, int index) {
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
    for (const PhaseTag& place : kPhaseTags)
        if (std::string value = phaseValue(groups, place); !value.empty())
            frame.phaseKeys[std::size_t(place.key)] = std::move(value);
    frame.meaning.quantity = quantityOf(groups, frame.phaseKeys[std::size_t(PhaseKey::imageType)]);
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
