#pragma once
/// The headers of volume files: one reader for each format, and what they share. Those of grid_file.h call them.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/volume/file/grid_file.h"

namespace pdr {

/// NIfTI-1 and -2 in one file. The place comes from the sform, or else from the qform.
Result<GridFile> readNifti(const NamedBytes& file);
/// NRRD with its samples inside or in one file beside it, raw or packed by gzip.
Result<GridFile> readNrrd(const NamedBytes& file);
/// MetaImage with its samples inside (.mha) or in one file beside it (.mhd), raw or packed by zlib.
Result<GridFile> readMetaImage(const NamedBytes& file);

/// Returns the error of a header that cannot be used.
Error refusedHeader(const std::filesystem::path& file, const Text& what);

/// The lines of a header that is text, and where its samples begin.
struct HeaderLines {
    std::vector<std::string> lines;  ///< without line ends and spaces at both ends
    std::uint64_t end = 0;           ///< the first byte behind the last line
};
/// Reads lines up to and including the first for which `isLast` is true, or to the end of the file. Errors: those of
/// checkPlainFile(); a header of more than 4 MB.
Result<HeaderLines> readLines(const NamedBytes& file, bool (*isLast)(std::string_view line));

/// Returns `text` without spaces at both ends.
std::string trimmed(std::string_view text);
/// Returns the parts of a line in front of and behind the first `separator`, trimmed; none without it.
std::optional<std::array<std::string, 2>> splitAt(std::string_view line, std::string_view separator);
/// Returns the numbers of a list; commas and brackets count as spaces. None if a word is no number, or if there are
/// not `count` of them.
std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count);
/// Returns a grid of `size`, whole numbers in [1, 65535], with steps and origin in the patient [mm]. None if the size
/// is none.
std::optional<VolumeGeometry> gridOf(const std::vector<double>& size, const std::array<dvec3, 3>& steps,
                                     const dvec3& origin);
/// Returns the path of the file `name` beside `header`. None if it is a list or a pattern, or lies outside the folder.
std::optional<std::filesystem::path> fileBeside(const std::filesystem::path& header, const std::string& name);

}  // namespace pdr
