#include "app/output/image_files.h"

#include <algorithm>
#include <optional>

#include "render/base/replacing_file.h"
#include "render/film/file/image_format.h"

namespace pdr::app {
namespace {

namespace fs = std::filesystem;

/// Removes the last character of UTF-8 text, which may be several bytes.
std::string withoutLastLetter(std::string text) {
    while (text.size() > 1 && (text.back() & 0xC0) == 0x80)
        text.pop_back();
    text.pop_back();
    return text;
}

/// Returns "head-2.png" in `folder`, or the first number after it that is free, up to 99; nothing if none is.
std::optional<fs::path> freeName(const fs::path& folder, const fs::path& name) {
    constexpr std::size_t kLongestName = 255;  // bytes
    std::error_code ignored;
    for (int number = 2; number < 100; ++number) {
        const std::string end = '-' + std::to_string(number) + name.extension().string();
        std::string stem = name.stem().string();
        while (stem.size() + end.size() > kLongestName && !stem.empty())
            stem = withoutLastLetter(stem);
        const fs::path place = folder / (stem + end);
        if (!fs::exists(fs::symlink_status(place, ignored)))
            return place;
    }
    return std::nullopt;
}

/// Returns where `output` could be written instead: beside its place, and in the current folder.
Paths substitutesFor(const fs::path& output) {
    Paths places;
    for (const fs::path& folder : {output.parent_path(), fs::path()})
        if (const auto place = freeName(folder, output.filename()); place && (places.empty() || places[0] != *place))
            places.push_back(*place);
    return places;
}

}  // namespace

Result<void> checkWritable(const Paths& outputs) {
    for (const auto& path : outputs)
        if (auto file = ReplacingFile::open(path, FileAccess::owner); !file)
            return file.error();
    return {};
}

Result<void> checkSpared(const Paths& inputs, const Paths& outputs) {
    std::error_code ignored;  // a file that does not exist is no input
    for (const auto& input : inputs)
        for (const auto& output : outputs)
            if (fs::equivalent(input, output, ignored))
                return Error{phrase("this file is read by the scene that is to be rendered"), output.string(),
                             phrase("Write to another one.")};
    return {};
}

bool anyPng(const Paths& outputs) {
    return std::ranges::any_of(outputs, [](const fs::path& path) { return imageFormat(path) == ImageFormat::png; });
}

WrittenFiles writeFiles(const Paths& outputs, const std::function<Result<void>(const fs::path&)>& write) {
    WrittenFiles written;
    for (const auto& output : outputs) {
        const auto wanted = write(output);
        if (wanted) {
            written.files.push_back(output);
            continue;
        }
        Error trouble = wanted.error();
        const Paths places = trouble.kind == ErrorKind::cancelled ? Paths() : substitutesFor(output);
        if (const auto place = std::ranges::find_if(places, [&](const auto& free) { return bool(write(free)); });
            place != places.end()) {
            written.files.push_back(*place);
            trouble.hint = phrase("The image is in %1 instead.", place->string());
        }
        written.troubles.push_back(trouble);
    }
    return written;
}

}  // namespace pdr::app
