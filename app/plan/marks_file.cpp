#include "app/plan/marks_file.h"

#include "app/plan/marks_csv.h"
#include "app/plan/marks_slicer.h"
#include "render/base/file_ending.h"
#include "render/base/replacing_file.h"

namespace pdr::app {
namespace {

bool isCsv(const std::filesystem::path& file) {
    return fileEnding(file) == ".csv";
}

bool isSlicers(const std::filesystem::path& file) {
    return fileEnding(file) == ".json" && fileEnding(file.stem()) == ".mrk";
}

}  // namespace

bool isMarksFile(const std::filesystem::path& file) {
    return isCsv(file) || isSlicers(file);
}

Result<void> writeMarks(const std::vector<MarkRow>& rows, const std::filesystem::path& file) {
    if (!isMarksFile(file))
        return Error{phrase("measurements are exported to files that end in .csv or .mrk.json"), file.string(), "",
                     ErrorKind::refused};
    if (rows.empty())
        return Error{phrase("there is no measurement to export"), "", "", ErrorKind::refused};
    return writeWhole(isCsv(file) ? marksCsv(rows) : marksForSlicer(rows), file, FileAccess::owner);
}

}  // namespace pdr::app
