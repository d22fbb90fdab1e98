#include "render/volume/file/label_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "render/base/unpacked_file.h"
#include "render/volume/file/grid_header.h"
#include "render/volume/file/scan_endings.h"

namespace pdr {
namespace {

std::optional<std::int64_t> wholeIn(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failure == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Returns the colour of three numbers from 0 to 1.
std::optional<LabelColour> colourIn(const std::string& text) {
    const auto channels = numbersIn(text, 3);
    if (!channels)
        return {};
    LabelColour colour;
    for (std::size_t i = 0; i < 3; ++i)
        colour[i] = std::uint8_t(std::lround(255 * std::clamp((*channels)[i], 0.0, 1.0)));
    return colour;
}

/// Returns the parts of Slicer's pairs: those of segment N begin with "SegmentN_".
LabelTable slicerLabels(const std::map<std::string, std::string>& pairs) {
    LabelTable table;
    for (int n = 0; n <= 65535; ++n) {
        const std::string segment = "Segment" + std::to_string(n) + "_";
        const auto of = [&](const char* field) {
            const auto found = pairs.find(segment + field);
            return found == pairs.end() ? std::string() : found->second;
        };
        const std::string name = of("Name");
        if (name.empty() && of("ID").empty())
            break;
        // Without the value, as in files of old versions, the segments are numbered from 1.
        if (const auto value = of("LabelValue").empty() ? n + 1 : wholeIn(of("LabelValue")))
            table[*value] = {name, colourIn(of("Color"))};
    }
    return table;
}

/// Returns what stands between the first `from` behind `at` and the next `to`; moves `at` behind that.
std::optional<std::string_view> between(std::string_view text, std::string_view from, std::string_view to,
                                        std::size_t& at) {
    const std::size_t begin = text.find(from, at);
    if (begin == std::string_view::npos)
        return {};
    const std::size_t end = text.find(to, begin + from.size());
    if (end == std::string_view::npos)
        return {};
    at = end + to.size();
    return text.substr(begin + from.size(), end - begin - from.size());
}

/// Returns the value of an attribute; `name`: " Key=" and so on.
std::string attribute(std::string_view tag, std::string_view name) {
    std::size_t at = 0;
    return std::string(between(tag, std::string(name).append("\""), "\"", at).value_or(""));
}

/// Returns the text of an element, out of its CDATA or with its entities in place.
std::string plainText(std::string_view text) {
    std::size_t at = 0;
    if (const auto inside = between(text, "<![CDATA[", "]]>", at))
        return trimmed(*inside);
    std::string plain = trimmed(text);
    constexpr std::array<std::array<std::string_view, 2>, 5> kEntities{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}};
    for (const auto& [entity, letter] : kEntities)
        for (std::size_t found = 0; (found = plain.find(entity, found)) != std::string::npos; found += letter.size())
            plain.replace(found, entity.size(), letter);
    return plain;
}

/// Returns the bytes between the header and the samples of a NIfTI file, up to 4 MB: its extensions.
std::string extensionsOf(const GridFile& grid) {
    constexpr std::uint64_t kMost = 4 << 20, kHeader = 348;
    const std::uint64_t end = std::max(grid.start, grid.skip);
    if (end <= kHeader)
        return {};
    const auto bytes = grid.open(grid.dataFile);
    if (!bytes)
        return {};
    std::string text(std::size_t(std::min(end - kHeader, kMost)), '\0');
    UnpackedFile file(*bytes, 0, grid.isPacked);
    const bool isRead =
        file.skip(kHeader) && file.read(std::span(reinterpret_cast<std::uint8_t*>(text.data()), text.size()));
    return isRead ? text : std::string();
}

bool isNifti(const std::filesystem::path& file) {
    return scanEnding(file).starts_with(".nii");
}

}  // namespace

LabelTable caretLabels(std::string_view xml) {
    LabelTable table;
    std::size_t in = 0;
    const std::string_view labels = between(xml, "<LabelTable>", "</LabelTable>", in).value_or("");
    std::size_t at = 0;
    while (const auto label = between(labels, "<Label ", "</Label>", at)) {
        const std::size_t open = label->find('>');
        const std::string tag = std::string(" ").append(label->substr(0, open));
        const auto value = wholeIn(attribute(tag, " Key="));
        if (value && open != std::string_view::npos)
            table[*value] = {
                plainText(label->substr(open + 1)),
                colourIn(attribute(tag, " Red=") + " " + attribute(tag, " Green=") + " " + attribute(tag, " Blue="))};
    }
    return table;
}

LabelTable labelTable(const GridFile& grid) {
    return isNifti(grid.file) ? caretLabels(extensionsOf(grid)) : slicerLabels(grid.pairs);
}

}  // namespace pdr
