#pragma once
/// Films in files, between two runs of this program: an image's sums, or those of some shares of it. The numbers lie in
/// a file as they lie in memory, so that only machines of one kind read each other's. A file is as much a patient's
/// image as a PNG is, and holds neither a name nor a path.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/batch/share.h"
#include "render/base/result.h"
#include "render/device/device.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

namespace pdr::app {

using ContentHash = std::array<std::byte, 32>;  ///< as of app/wire/content_hash.h

/// What films of one image have in common, and no others.
struct FilmOrigin {
    std::array<char, 32> program{};  ///< version of the program
    ContentHash bits{};              ///< hash of the device's reference tiles; equal: devices take the same samples
    ContentHash scene{};             ///< hash of everything but voxels
    ContentHash voxels{};            ///< hash of the voxels of volume and label map
    std::uint64_t seed = 0;
    ivec2 size{0};              ///< size of the whole image in pixels
    std::uint64_t samples = 0;  ///< samples of each pixel
    int shares = 1;             ///< number of shares of the image
    bool operator==(const FilmOrigin&) const = default;
};

/// Returns the origin of films of `scene` that `device` takes. Errors: the device's; it holds another scene afterwards.
Result<FilmOrigin> filmOrigin(const Scene& scene, Device& device, std::uint64_t samples, int shares);

/// The sums of one share, in the order of its tiles and, within a tile, row by row.
struct FilmShare {
    int number = 1;
    double seconds = 0;  ///< rendering time
    std::vector<Moments> moments;
    std::vector<PixelSums> block;
    Health health;
};

/// Shares of one image, by ascending number.
struct SavedFilm {
    FilmOrigin origin;
    std::vector<FilmShare> shares;
};

/// Adds the sums of `film`, which holds `tile`, the next one of its share, to `share`.
void addTile(FilmShare& share, const Film& film);
/// Returns the film of the whole image. All shares must be there.
std::shared_ptr<const Film> wholeFilm(const SavedFilm& saved, std::uint64_t revision);
/// Returns `film`, a whole image, as a single share.
SavedFilm savedFilm(const Film& film, const FilmOrigin& origin, double seconds);

/// Writes `saved` to `path`; only the owner can read a new file. Errors: those of files.
Result<void> writeFilm(const SavedFilm& saved, const std::filesystem::path& path);
/// Reads the file at `path`. Errors: those of files; it is no film; another version's; damaged.
Result<SavedFilm> readFilm(const std::filesystem::path& path);

}  // namespace pdr::app
