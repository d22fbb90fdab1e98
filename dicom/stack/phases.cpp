#include "dicom/stack/phases.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "dicom/stack/sorted_stack.h"

namespace pdr::dicom {

namespace {

using Slices = std::vector<const SliceHeader*>;

/// Returns whether two slices lie at one height, or one of them has no place.
bool takesAPlaceTwice(const Slices& slices) {
    const auto isPlaced = [](const SliceHeader* slice) {
        return slice->position && slice->rowDirection && slice->columnDirection;
    };
    if (!std::ranges::all_of(slices, isPlaced))
        return true;
    const SliceHeader& first = *slices.front();
    const dvec3 normal = glm::normalize(glm::cross(*first.rowDirection, *first.columnDirection));
    std::vector<double> heights;
    heights.reserve(slices.size());
    for (const SliceHeader* slice : slices)
        heights.push_back(glm::dot(*slice->position, normal));
    std::ranges::sort(heights);
    return std::ranges::adjacent_find(heights, [](double a, double b) { return b - a <= kSamePlaceMm; }) !=
           heights.end();
}

/// Returns the number that a value begins with; none if it begins with no number.
std::optional<double> numberOf(const std::string& value) {
    double number = 0;
    const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
    return failure == std::errc() ? std::optional(number) : std::nullopt;
}

bool ascend(const std::string& a, const std::string& b) {
    const auto left = numberOf(a), right = numberOf(b);
    return left && right && *left != *right ? *left < *right : a < b;
}

/// Returns DICOM's "101530.25" as "10:15:30.25"; anything else unchanged.
std::string timeOfDay(const std::string& time) {
    const bool isTime = time.size() >= 6 && std::all_of(time.begin(), time.begin() + 6,
                                                        [](char letter) { return letter >= '0' && letter <= '9'; });
    return isTime ? time.substr(0, 2) + ":" + time.substr(2, 2) + ":" + time.substr(4) : time;
}

/// Returns the name of a b-value and the direction behind it, if there is one.
Text diffusionName(const std::string& value) {
    const std::size_t end = value.find(' ');
    const Text bValue = phrase("b %1", value.substr(0, end));
    return end == std::string::npos ? bValue : phrase("%1 along %2", bValue, value.substr(end + 1));
}

Text nameOf(PhaseKey key, const std::string& value) {
    switch (key) {
        case PhaseKey::stack:
            return phrase("stack %1", value);
        case PhaseKey::echoTime:
            return phrase("TE %1 ms", value);
        case PhaseKey::echoNumber:
            return phrase("echo %1", value);
        case PhaseKey::diffusion:
            return diffusionName(value);
        case PhaseKey::temporalPosition:
            return phrase("point in time %1", value);
        case PhaseKey::cardiacPercentage:
            return phrase("%1 % of the heartbeat", value);
        case PhaseKey::triggerTime:
            return phrase("%1 ms after the heartbeat", value);
        case PhaseKey::acquisitionNumber:
            return phrase("acquisition %1", value);
        case PhaseKey::acquisitionTime:
        case PhaseKey::contentTime:
            return phrase("taken at %1", timeOfDay(value));
        case PhaseKey::kvp:
            return phrase("X-rays of %1 kV", value);
        case PhaseKey::imageType:
            break;
    }
    return Text(value);
}

/// What a slice states for each of some keys.
using Values = std::vector<std::string>;

bool ascendInTurn(const Values& left, const Values& right) {
    return std::ranges::lexicographical_compare(left, right, ascend);
}

Text nameOf(const std::vector<PhaseKey>& keys, const Values& values) {
    Text name = nameOf(keys[0], values[0]);
    for (std::size_t i = 1; i < keys.size(); ++i)
        name = phrase("%1, %2", name, nameOf(keys[i], values[i]));
    return name;
}

/// Splits by the values of `keys` together; empty if that does not give whole phases.
std::vector<Phase> splitBy(const std::vector<PhaseKey>& keys, const Slices& slices) {
    std::map<Values, Slices, decltype(&ascendInTurn)> byValue(&ascendInTurn);
    for (const SliceHeader* slice : slices) {
        Values values;
        for (const PhaseKey key : keys)
            values.push_back(slice->phaseValues[std::size_t(key)]);
        if (std::ranges::find(values, std::string()) != values.end())
            return {};
        byValue[values].push_back(slice);
    }
    if (byValue.size() < 2)
        return {};
    const auto [least, most] =
        std::ranges::minmax_element(byValue, {}, [](const auto& phase) { return phase.second.size(); });
    const bool isEven = least->second.size() >= 2 && most->second.size() - least->second.size() <= 1;
    if (!isEven || std::ranges::any_of(byValue, [](const auto& phase) { return takesAPlaceTwice(phase.second); }))
        return {};
    std::vector<Phase> phases;
    phases.reserve(byValue.size());
    for (const auto& [values, phase] : byValue)
        phases.push_back({phase, nameOf(keys, values)});
    return phases;
}

/// Returns each key alone, then each two of them, in the order in which they are asked.
std::vector<std::vector<PhaseKey>> keysInTurn() {
    std::vector<std::vector<PhaseKey>> all;
    for (std::size_t key = 0; key < kPhaseKeys; ++key)
        all.push_back({PhaseKey(key)});
    for (std::size_t first = 0; first < kPhaseKeys; ++first)
        for (std::size_t second = first + 1; second < kPhaseKeys; ++second)
            all.push_back({PhaseKey(first), PhaseKey(second)});
    return all;
}

}  // namespace

std::vector<Phase> phasesOf(const Slices& slices) {
    if (takesAPlaceTwice(slices))
        for (const std::vector<PhaseKey>& keys : keysInTurn())
            if (std::vector<Phase> phases = splitBy(keys, slices); !phases.empty())
                return phases;
    return {{slices, {}}};
}

}  // namespace pdr::dicom
