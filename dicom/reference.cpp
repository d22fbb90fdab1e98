#include "dicom/reference.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace pdr::dicom {

namespace {

/// Returns whether `uid` is made of at most 64 digits and dots, with a number on both sides of each dot (PS3.5, 9.1).
/// Leading zeros are accepted, although the standard forbids them: archives keep such an image under this very UID.
bool isWellFormed(std::string_view uid) {
    constexpr std::size_t kLongest = 64;
    const auto belongs = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
    return !uid.empty() && uid.size() <= kLongest && std::ranges::all_of(uid, belongs) && uid.front() != '.' &&
           uid.back() != '.' && uid.find("..") == std::string_view::npos;
}

std::string wellFormed(const std::string& uid) {
    return isWellFormed(uid) ? uid : std::string();
}

/// Returns the frame of reference of all slices; empty if they name none or several.
std::string commonFrameOfReference(const std::vector<SliceRef>& slices) {
    if (slices.empty())
        return {};
    const std::string& first = slices.front().identity.frameOfReferenceUid;
    const auto isFirst = [&](const SliceRef& slice) { return slice.identity.frameOfReferenceUid == first; };
    return std::ranges::all_of(slices, isFirst) ? wellFormed(first) : std::string();
}

std::vector<ImageReference> imagesOf(const std::vector<SliceRef>& slices) {
    std::map<std::pair<std::string, int>, int> uses;
    for (const SliceRef& slice : slices)
        ++uses[{slice.identity.sopInstanceUid, slice.frame}];
    std::vector<ImageReference> images;
    for (const SliceRef& slice : slices) {
        const std::string& instance = slice.identity.sopInstanceUid;
        const bool isUnique = uses[{instance, slice.frame}] == 1;
        images.push_back(
            {wellFormed(slice.identity.sopClassUid), isUnique ? wellFormed(instance) : std::string(), slice.frame + 1});
    }
    return images;
}

}  // namespace

SeriesReference referenceTo(const Series& series) {
    return {wellFormed(series.study.uid), wellFormed(series.series.uid), commonFrameOfReference(series.slices),
            imagesOf(series.slices)};
}

}  // namespace pdr::dicom
