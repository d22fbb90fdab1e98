#include "dicom/stack/stack_notes.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "dicom/read/codecs.h"
#include "dicom/stack/series_unit.h"

namespace pdr::dicom {

namespace {

using Slices = std::vector<const SliceHeader*>;

void noteMeaning(const Slices& slices, const FittedUnit& fitted, std::vector<Note>& notes) {
    std::size_t withoutRescale = 0;
    std::set<std::string> frames, studies;
    for (const SliceHeader* slice : slices) {
        studies.insert(slice->study.uid);
        withoutRescale += !slice->meaning.isByTable && (!slice->meaning.slope || !slice->meaning.intercept);
        frames.insert(slice->frameOfReferenceUid);
    }
    const bool isHu = fitted.unit.isHu;
    noteUnit(slices, fitted, notes);
    if (isHu && withoutRescale > 0)
        notes.push_back(
            {"rescale", phrase(withoutRescale == 1 ? "1 slice states no rescale; stored values are taken as HU"
                                                   : "%1 slices state no rescale; stored values are taken as HU",
                               withoutRescale)});
    if (const std::string& modality = slices.front()->series.modality; isHu && modality != "CT")
        notes.push_back({"modality", phrase("the files call the series %1, not CT, and its values HU", modality)});
    if (studies.size() > 1)
        notes.push_back(
            {"studies", phrase("the files name %1 studies; their slices are taken as one series", studies.size())});
    // Some de-identifiers give every file a frame of its own; a true second frame would show as a broken stack.
    if (frames.size() > 1)
        notes.push_back({"frames", phrase("the files name %1 frames of reference; their positions are taken as one",
                                          frames.size())});
}

void noteLoss(const Slices& slices, std::vector<Note>& notes) {
    const auto isLossy = [](const SliceHeader* slice) { return slice->isLossy; };
    const auto lossy = std::size_t(std::count_if(slices.begin(), slices.end(), isLossy));
    const auto unsure = std::size_t(std::ranges::count(slices, true, &SliceHeader::mayBeLossy));
    if (unsure > 0)
        notes.push_back({"maybe-lossy", phrase(unsure == 1 ? "1 slice may have been compressed with loss: its coding "
                                                             "allows that, and its file does not say"
                                                           : "%1 slices may have been compressed with loss: their "
                                                             "coding allows that, and their files do not say",
                                               unsure)});
    if (lossy == 0)
        return;
    const SliceHeader& first = **std::find_if(slices.begin(), slices.end(), isLossy);
    const bool byItsCoding = codingIsLossy(first.transferSyntaxUid) || codingMayLose(first.transferSyntaxUid);
    Text how = byItsCoding ? Text(transferSyntaxName(first.transferSyntaxUid)) : phrase("an earlier coding");
    if (first.lossyRatio)
        how = phrase("%1, %2:1", how, numberOf(*first.lossyRatio, 3));
    notes.push_back(
        {"lossy", phrase(lossy == 1 ? "1 slice was compressed with loss (%2): the values are not those that were "
                                      "measured"
                                    : "%1 slices were compressed with loss (%2): the values are not those that "
                                      "were measured",
                         lossy, how)});
}

/// Returns whether the slices' numbers count on along the stack, as scanners number them.
bool areNumberedInOrder(const Slices& slices) {
    int steps = 0;
    for (std::size_t k = 1; k < slices.size(); ++k) {
        if (!slices[k]->instanceNumber || !slices[k - 1]->instanceNumber)
            return false;
        steps += std::abs(*slices[k]->instanceNumber - *slices[k - 1]->instanceNumber) == 1;
    }
    return slices.size() > 1 && 10 * std::size_t(steps) >= 9 * (slices.size() - 1);
}

/// Returns how many images the acquisition of all slices made, if they state it, and are of one acquisition.
std::optional<std::size_t> acquisitionImages(const Slices& slices) {
    const auto acquisitionOf = [](const SliceHeader* slice) {
        return std::pair(slice->acquisitionImages, slice->phaseValues[std::size_t(PhaseKey::acquisitionNumber)]);
    };
    const auto first = acquisitionOf(slices.front());
    const bool isOne = std::ranges::all_of(slices, [&](const auto* slice) { return acquisitionOf(slice) == first; });
    return isOne && first.first > 0 ? std::optional(std::size_t(*first.first)) : std::nullopt;
}

/// Notes that a few images of the acquisition are not there. Many may belong to another series: the same acquisition
/// may have been reconstructed twice.
void noteMissingImages(std::size_t stated, std::size_t seen, std::vector<Note>& notes) {
    constexpr std::size_t kFew = 10;  // one of ten
    const std::size_t missing = stated > seen ? stated - seen : 0;
    if (missing == 0 || missing * kFew > std::max(seen, kFew))
        return;
    notes.push_back({"incomplete", phrase(missing == 1 ? "1 slice may be missing: the files state that their "
                                                         "acquisition made %2 images, and %3 are there"
                                                       : "%1 slices may be missing: the files state that their "
                                                         "acquisition made %2 images, and %3 are there",
                                          missing, stated, seen)});
}

/// Notes that slices may be missing. Positions cannot show that a slice is missing at an end; its number can, or how
/// many images the acquisition made.
void noteMissing(const Slices& slices, const std::set<int>& numbers, std::vector<Note>& notes) {
    constexpr int kHabit = 100;  // numbers that begin there or later begin so by habit: nothing is missing before them
    const auto lowest = numbers.lower_bound(1);
    if (!areNumberedInOrder(slices) || lowest == numbers.end())
        return;
    const std::optional<std::size_t> stated = acquisitionImages(slices);
    if (stated == slices.size() || stated == numbers.size())
        return;
    int first = *lowest < kHabit ? 1 : *lowest;
    const std::size_t missing =
        std::size_t(*numbers.rbegin() - first + 1) - std::size_t(std::distance(lowest, numbers.end()));
    if (missing == 0 && stated)
        noteMissingImages(*stated, numbers.size(), notes);
    if (missing == 0 || missing > slices.size())
        return;
    while (numbers.contains(first))
        ++first;
    notes.push_back(
        {"incomplete",
         phrase(missing == 1 ? "1 slice may be missing: the files are numbered up to %2, and number %3 is not "
                               "there"
                             : "%1 slices may be missing: the files are numbered up to %2, and number %3 and "
                               "others are not there",
                missing, *numbers.rbegin(), first)});
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 3); ++i)
        list += (i > 0 ? ", " : "") + names[i];
    return names.size() > 3 ? list + " ..." : list;
}

std::string shortName(const std::filesystem::path& file, const std::filesystem::path& root) {
    return file.lexically_relative(root).string();
}

std::string sliceName(const SliceHeader& slice, const std::filesystem::path& root) {
    const std::string name = shortName(slice.file, root);
    return slice.frames > 1 ? name + " #" + std::to_string(slice.frame + 1) : name;
}

std::vector<SlicePlane> planesOf(const Slices& headers, const std::filesystem::path& root) {
    std::vector<SlicePlane> planes;
    for (const SliceHeader* header : headers)
        planes.push_back({sliceName(*header, root),
                          {header->columns, header->rows},
                          header->position,
                          header->rowDirection,
                          header->columnDirection,
                          header->spacingMm});
    return planes;
}

std::vector<Note> notesOn(const Slices& slices, const FittedUnit& unit, const std::set<int>& numbers) {
    std::vector<Note> notes;
    noteMeaning(slices, unit, notes);
    noteLoss(slices, notes);
    if (!numbers.empty())
        noteMissing(slices, numbers, notes);
    return notes;
}

}  // namespace pdr::dicom
