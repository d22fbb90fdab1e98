#include "dicom/read/fragments.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "dicom/read/element.h"

namespace pdr::dicom {

namespace {

constexpr std::uint64_t kItemHeaderBytes = 8;

/// Indices of the fragments that frames begin with.
using Starts = std::vector<std::size_t>;

std::vector<std::uint32_t> offsetTable(ByteSource& source, const Element& item) {
    std::vector<std::uint8_t> bytes(item.length);
    if (!source.read(item.value, bytes))
        return {};
    std::vector<std::uint32_t> offsets;
    offsets.reserve(bytes.size() / 4);
    for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4)
        offsets.push_back(bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 | std::uint32_t(bytes[i + 3]) << 24);
    return offsets;
}

/// Returns the fragments at the offsets of the table; empty unless each offset is where one begins, and they ascend
/// from 0.
Starts startsByTable(const FragmentList& list) {
    Starts starts;
    const auto offsetOf = [&](std::size_t i) { return list.fragments[i].at - list.fragments[0].at; };
    std::size_t i = 0;
    for (const std::uint32_t offset : list.offsets) {
        while (i < list.fragments.size() && offsetOf(i) < offset)
            ++i;
        if (i == list.fragments.size() || offsetOf(i) != offset || (starts.empty() && i != 0))
            return {};
        starts.push_back(i++);
    }
    return starts;
}

/// Returns whether a fragment begins with the first marker of a JPEG stream (SOI and another) or of a JPEG 2000
/// codestream (SOC, SIZ).
bool beginsStream(ByteSource& source, const Fragment& fragment) {
    std::array<std::uint8_t, 4> head{};
    if (fragment.bytes < head.size() || !source.read(fragment.at, head))
        return false;
    const bool isJpeg = head[1] == 0xD8 && head[2] == 0xFF, isJpeg2000 = head[1] == 0x4F && head[2] == 0xFF;
    return head[0] == 0xFF && (isJpeg || isJpeg2000);
}

Starts startsByMarker(ByteSource& source, const FragmentList& list) {
    Starts starts;
    for (std::size_t i = 0; i < list.fragments.size(); ++i)
        if (beginsStream(source, list.fragments[i]))
            starts.push_back(i);
    return !starts.empty() && starts.front() == 0 ? starts : Starts();
}

}  // namespace

FragmentList readFragments(ByteSource& source, std::uint64_t at) {
    FragmentList list;
    bool isTable = true;
    for (;;) {
        const std::optional<Element> item = readElement(source, at, {});
        if (!item || item->tag != kItem || item->length > source.size() - item->value)
            return list;
        if (isTable)
            list.offsets = offsetTable(source, *item);
        else
            list.fragments.push_back({item->value, item->length});
        isTable = false;
        at = item->value + item->length;
    }
}

std::vector<std::vector<Fragment>> fragmentsOfFrames(ByteSource& source, const FragmentList& list, int frames) {
    const auto count = std::size_t(frames);
    if (list.fragments.empty())
        return {};
    Starts starts(list.fragments.size());
    std::iota(starts.begin(), starts.end(), std::size_t(0));
    if (starts.size() != count)
        starts = startsByTable(list);
    if (starts.size() != count)
        starts = startsByMarker(source, list);
    if (starts.size() != count)
        return {};
    starts.push_back(list.fragments.size());
    std::vector<std::vector<Fragment>> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        result.emplace_back(list.fragments.begin() + std::ptrdiff_t(starts[i]),
                            list.fragments.begin() + std::ptrdiff_t(starts[i + 1]));
    return result;
}

}  // namespace pdr::dicom
