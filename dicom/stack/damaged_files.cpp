#include "dicom/stack/damaged_files.h"

#include <algorithm>
#include <map>
#include <set>

#include "dicom/read/byte_source.h"
#include "dicom/stack/stack_notes.h"
#include "render/base/file_ending.h"

namespace pdr::dicom {

namespace {

namespace fs = std::filesystem;

/// Returns the shape of a name: "IM#" for "IM0007".
std::string withoutNumbers(const std::string& name) {
    std::string shape;
    for (const char c : name) {
        const bool isDigit = c >= '0' && c <= '9';
        if (!isDigit || shape.empty() || shape.back() != '#')
            shape += isDigit ? '#' : c;
    }
    return shape;
}

/// Returns the ending of a file: ".dcm" for "7.DCM"; empty if it is a number, as in a UID.
std::string ending(const fs::path& file) {
    std::string text = fileEnding(file);
    const bool isWord = std::ranges::any_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
    return isWord ? text : "";
}

/// The names of the slices in a folder.
struct FileNames {
    std::set<std::string> shapes, endings;

    bool hold(const fs::path& file) const {
        return shapes.contains(withoutNumbers(file.filename().string())) || endings.contains(ending(file));
    }
};

bool isEmpty(const SeriesSource& source, const fs::path& file) {
    const Result<NamedBytes> object = source.open(file);
    if (!object)
        return false;
    const ByteSource bytes(*object);
    return bytes.opened() && bytes.size() == 0;
}

using Names = std::vector<std::string>;

/// Returns every folder that holds slices of the series, and every folder that holds such a folder, up to `root`.
std::set<fs::path> foldersOf(const Series& series, const fs::path& root) {
    std::set<fs::path> folders;
    for (const SliceRef& slice : series.slices) {
        fs::path folder = slice.file.parent_path();
        while (folders.insert(folder).second && folder != root && folder.has_relative_path())
            folder = folder.parent_path();
    }
    return folders;
}

void note(Series& series, const Names& own, const Names& beside) {
    if (!own.empty())
        series.verdict.notes.push_back(
            {"damaged", phrase(own.size() == 1 ? "1 damaged file of this series left out (%2)"
                                               : "%1 damaged files of this series left out (%2)",
                               own.size(), listed(own))});
    if (!beside.empty())
        series.verdict.notes.push_back(
            {"unread",
             phrase(beside.size() == 1 ? "1 file could not be read, and slices of this series may be missing (%2)"
                                       : "%1 files could not be read, and slices of this series may be missing (%2)",
                    beside.size(), listed(beside))});
}

}  // namespace

std::vector<Problem> spoiltFiles(const SeriesSource& source, const std::vector<fs::path>& foreign,
                                 const std::vector<SliceHeader>& slices) {
    std::map<fs::path, FileNames> folders;
    for (const SliceHeader& slice : slices) {
        FileNames& names = folders[slice.file.parent_path()];
        names.shapes.insert(withoutNumbers(slice.file.filename().string()));
        if (const std::string end = ending(slice.file); !end.empty())
            names.endings.insert(end);
    }
    std::vector<Problem> spoilt;
    for (const fs::path& file : foreign) {
        const auto folder = folders.find(file.parent_path());
        if (folder == folders.end() || file.filename().string().starts_with('.'))
            continue;
        if (isEmpty(source, file))
            spoilt.push_back({file, phrase("it is empty")});
        else if (folder->second.hold(file))
            spoilt.push_back({file, phrase("it is called as the slices beside it, but holds no DICOM")});
    }
    return spoilt;
}

void noteDamaged(const std::vector<SliceHeader>& damaged, const fs::path& root, std::vector<Series>& all) {
    std::map<std::string, Names> named;
    std::map<fs::path, Names> nameless;  // by folder
    for (const SliceHeader& header : damaged) {
        Names& names = header.series.uid.empty() ? nameless[header.file.parent_path()] : named[header.series.uid];
        names.push_back(shortName(header.file, root));
    }
    // Find the folders of each series
    std::vector<std::set<fs::path>> folders;
    folders.reserve(all.size());
    for (const Series& series : all)
        folders.push_back(foldersOf(series, root));
    const auto holdsNone = [&](const fs::path& folder) {
        return std::ranges::none_of(folders, [&](const auto& some) { return some.contains(folder); });
    };
    // Note each file on the series that may lack it
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].verdict.stack == Stack::notCt)
            continue;
        Names beside;
        for (const auto& [folder, names] : nameless)
            if (folders[i].contains(folder) || holdsNone(folder))
                beside.insert(beside.end(), names.begin(), names.end());
        note(all[i], named[all[i].series.uid], beside);
    }
}

}  // namespace pdr::dicom
