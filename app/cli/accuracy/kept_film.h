#pragma once
/// File format of a film that is saved between two runs of a report. Only this program reads it, on a machine like the
/// one that wrote it, because it holds values as they lie in memory.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

namespace pdr::app {

struct KeptFilm {
    std::shared_ptr<const Film> film;
    double seconds = 0;  ///< rendering time of the film
};

/// Returns a hash of everything that determines films of `scene` on a device of that name, including its voxels and the
/// version of this program.
std::uint64_t filmKey(const Scene& scene, const std::string& device);

/// Writes `kept` to `path`. All pixels of `kept.film` have the same number of samples. Errors: those of files.
Result<void> writeFilm(const KeptFilm& kept, std::uint64_t key, const std::filesystem::path& path);
/// Reads the file at `path` as a film of `scene`. Null if there is none, if it was made from something else (another
/// `key`), or if it is damaged.
std::optional<KeptFilm> readFilm(const Scene& scene, std::uint64_t key, const std::filesystem::path& path);

}  // namespace pdr::app
