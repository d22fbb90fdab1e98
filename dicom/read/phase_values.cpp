#include "dicom/read/phase_values.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <array>
#include <cmath>
#include <utility>

#include "dicom/read/item_values.h"

namespace pdr::dicom {

namespace {

/// Where an image says what tells it from others of its place.
struct PhasePlace {
    PhaseKey key;
    DcmTagKey tag;  ///< in an object of one image, and among the unassigned attributes of a legacy converted one
    DcmTagKey group, tagOfFrame;  ///< in a functional group
};

const std::array<PhasePlace, kPhaseKeys> kPlaces{{
    {PhaseKey::stack, DCM_StackID, DCM_FrameContentSequence, DCM_StackID},
    {PhaseKey::echoTime, DCM_EchoTime, DCM_MREchoSequence, DCM_EffectiveEchoTime},
    {PhaseKey::echoNumber, DCM_EchoNumbers, DCM_MREchoSequence, DCM_EchoNumbers},
    {PhaseKey::diffusion, DCM_DiffusionBValue, DCM_MRDiffusionSequence, DCM_DiffusionBValue},
    {PhaseKey::temporalPosition, DCM_TemporalPositionIdentifier, DCM_FrameContentSequence, DCM_TemporalPositionIndex},
    {PhaseKey::cardiacPercentage, DCM_NominalPercentageOfCardiacPhase, DCM_CardiacSynchronizationSequence,
     DCM_NominalPercentageOfCardiacPhase},
    {PhaseKey::triggerTime, DCM_TriggerTime, DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime},
    {PhaseKey::kvp, DCM_KVP, DCM_CTXRayDetailsSequence, DCM_KVP},
    {PhaseKey::acquisitionNumber, DCM_AcquisitionNumber, DCM_FrameContentSequence, DCM_FrameAcquisitionNumber},
    {PhaseKey::acquisitionTime, DCM_AcquisitionTime, DCM_FrameContentSequence, DCM_FrameAcquisitionDateTime},
    {PhaseKey::contentTime, DCM_ContentTime, DCM_FrameContentSequence, DCM_FrameReferenceDateTime},
    {PhaseKey::imageType, DCM_ImageType, DCM_CTImageFrameTypeSequence, DCM_FrameType},
}};

/// Returns a number without superfluous digits, or a text as it is; empty if it is not there.
std::string valueOf(DcmItem& item, const DcmTagKey& tag) {
    Float64 value = 0, second = 0;
    const bool isOne = item.findAndGetFloat64(tag, value).good() && item.findAndGetFloat64(tag, second, 1).bad();
    return isOne ? std::string(numberOf(value)) : text(item, tag);
}

/// Returns the direction of a diffusion gradient, with a space in front; empty if none is stated, as of a trace.
std::string directionOf(DcmItem& item) {
    DcmItem* group = firstItem(item, DCM_DiffusionGradientDirectionSequence);
    std::string direction;
    for (unsigned long axis = 0; axis < 3; ++axis) {
        Float64 along = 0;
        if ((group ? *group : item).findAndGetFloat64(DCM_DiffusionGradientOrientation, along, axis).bad())
            return {};
        // Directions of one series are further apart than a hundredth. No "-0"
        direction += ' ' + std::string(numberOf(std::round(100 * along) / 100 + 0.0));
    }
    return direction;
}

std::string diffusionOf(DcmItem& item) {
    const std::string bValue = valueOf(item, DCM_DiffusionBValue);
    return bValue.empty() || bValue == "0" ? bValue : bValue + directionOf(item);
}

std::string valueAt(DcmItem& item, PhaseKey key, const DcmTagKey& tag) {
    return key == PhaseKey::diffusion ? diffusionOf(item) : valueOf(item, tag);
}

std::string valueOfFrame(const FunctionalGroups& groups, const PhasePlace& place) {
    if (DcmItem* group = groups.find(place.group))
        if (std::string value = valueAt(*group, place.key, place.tagOfFrame); !value.empty())
            return value;
    DcmItem* own = firstItem(groups.own, DCM_UnassignedPerFrameConvertedAttributesSequence);
    DcmItem* shared =
        groups.shared ? firstItem(*groups.shared, DCM_UnassignedSharedConvertedAttributesSequence) : nullptr;
    for (DcmItem* item : {own, shared})
        if (std::string value = item ? valueAt(*item, place.key, place.tag) : ""; !value.empty())
            return value;
    return {};
}

}  // namespace

PhaseValues phaseValues(DcmItem& item) {
    PhaseValues values;
    for (const PhasePlace& place : kPlaces)
        values[std::size_t(place.key)] = valueAt(item, place.key, place.tag);
    return values;
}

void readPhaseValues(const FunctionalGroups& groups, PhaseValues& values) {
    for (const PhasePlace& place : kPlaces)
        if (std::string value = valueOfFrame(groups, place); !value.empty())
            values[std::size_t(place.key)] = std::move(value);
}

}  // namespace pdr::dicom
