#include "render/volume/file/grid_header.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <sstream>

#include "render/base/unpacked_file.h"

namespace pdr {

Error refusedHeader(const std::filesystem::path& file, const Text& what) {
    return {what, file.string(), phrase("Export the scan as DICOM, or anew in this format."), ErrorKind::refused};
}

Result<HeaderLines> readLines(const NamedBytes& file, bool (*isLast)(std::string_view line)) {
    constexpr std::uint64_t kMost = 4 << 20;
    UnpackedFile source(file, 0, false);
    std::array<std::uint8_t, 4096> piece;
    HeaderLines header;
    std::string line;
    for (;;) {
        const Result<std::size_t> count = source.readSome(piece);
        if (!count)
            return count.error();
        for (const std::uint8_t byte : std::span(piece).first(*count)) {
            if (++header.end > kMost)
                return refusedHeader(file.name, phrase("its header has no end"));
            if (byte != '\n') {
                line += char(byte);
                continue;
            }
            header.lines.push_back(trimmed(line));
            line.clear();
            if (isLast(header.lines.back()))
                return header;
        }
        if (*count == 0)
            break;
    }
    header.lines.push_back(trimmed(line));
    return header;
}

std::string trimmed(std::string_view text) {
    constexpr std::string_view kSpaces = " \t\r";
    const std::size_t first = text.find_first_not_of(kSpaces);
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(kSpaces) - first + 1));
}

std::optional<std::array<std::string, 2>> splitAt(std::string_view line, std::string_view separator) {
    const std::size_t at = line.find(separator);
    if (at == std::string_view::npos)
        return {};
    return std::array{trimmed(line.substr(0, at)), trimmed(line.substr(at + separator.size()))};
}

std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count) {
    std::string plain(text);
    std::ranges::replace_if(
        plain, [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
    std::istringstream words(plain);
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        double number = 0;
        const char *begin = word.data() + (word.front() == '+'), *end = word.data() + word.size();
        const auto [stop, failure] = std::from_chars(begin, end, number);
        if (failure != std::errc() || stop != end || numbers.size() == count)
            return {};
        numbers.push_back(number);
    }
    return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

std::optional<VolumeGeometry> gridOf(const std::vector<double>& size, const std::array<dvec3, 3>& steps,
                                     const dvec3& origin) {
    VolumeGeometry grid;
    for (int axis = 0; axis < 3; ++axis) {
        const double count = size[std::size_t(axis)];
        if (!(count >= 1 && count <= 65535 && count == double(int(count))))
            return {};
        grid.size[axis] = int(count);
        grid.patientFromIndex[axis] = dvec4(steps[std::size_t(axis)], 0.0);
    }
    grid.patientFromIndex[3] = dvec4(origin, 1.0);
    return grid;
}

std::optional<std::filesystem::path> fileBeside(const std::filesystem::path& header, const std::string& name) {
    const std::filesystem::path path(name);
    const bool leadsOut = std::ranges::find(path, "..") != path.end();
    if (name.empty() || path.is_absolute() || leadsOut || name.find('%') != std::string::npos ||
        name.starts_with("LIST"))
        return {};
    return header.parent_path() / path;
}

}  // namespace pdr
