#include "render/volume/file/label_folder.h"

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <vector>

#include "render/volume/file/label_file.h"
#include "render/volume/file/scan_endings.h"
#include "render/volume/joined_labels.h"

namespace pdr {
namespace {

namespace fs = std::filesystem;

Error refusedFolder(const fs::path& folder, const Text& what) {
    return {what, folder.string(), phrase("Choose a folder with a NIfTI, NRRD or MetaImage mask of each part."),
            ErrorKind::refused};
}

Result<std::vector<fs::path>> masksIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    fs::directory_iterator entry(folder, failed);
    for (; !failed && entry != fs::directory_iterator(); entry.increment(failed))
        if (isGridFile(entry->path()))
            files.push_back(entry->path());
    if (failed)
        return Error{phrase("the folder cannot be read (%1)", failed.message()), folder.string(), ""};
    std::ranges::sort(files);
    return files;
}

/// Returns the name of a file without its endings: "liver" of "liver.nii.gz".
std::string plainName(const std::filesystem::path& file) {
    std::string name = file.filename().string();
    name.resize(name.size() - scanEnding(file).size());
    if (name.ends_with(".seg"))
        name.resize(name.size() - 4);
    return name;
}

}  // namespace

Result<LabelMap> readLabelFolder(const fs::path& folder, const Progress& progress) {
    const Result<std::vector<fs::path>> files = masksIn(folder);
    if (!files)
        return files.error();
    if (files->empty())
        return refusedFolder(folder, phrase("it holds no label map"));
    JoinedLabels joined;
    std::int64_t empty = 0;
    for (std::size_t i = 0; i < files->size(); ++i) {
        const double share = 1 / double(files->size());
        Result<LabelMap> map = readLabelFile((*files)[i], partOf(progress, share * double(i), share * double(i + 1)),
                                             onDisk, Unmarked::taken);
        if (!map)
            return map;
        if (map->parts.size() == 1 && map->parts[0].name == standardName(1))
            map->parts[0].name = plainName((*files)[i]);
        if (map->parts.empty())
            ++empty;
        else if (auto ok = joined.add(*std::move(map)); !ok)
            return ok.error().in((*files)[i].string());
    }
    LabelMap map = joined.take();
    if (map.parts.empty())
        return refusedFolder(folder, phrase("it marks no voxel"));
    if (empty > 0)
        map.notes.push_back(emptyPartsNote(empty));
    return map;
}

}  // namespace pdr
