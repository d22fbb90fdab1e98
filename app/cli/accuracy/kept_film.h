#pragma once
/// A film between two runs of a report, in a file that only this program reads, on a machine like the one that wrote
/// it.

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
    double seconds = 0;  ///< that it took
};

/// Of all that films of `scene` on a device of that name are made from, its voxels and this version among it.
std::uint64_t filmKey(const Scene& scene, const std::string& device);

/// `kept.film` is equally far everywhere. Errors: those of files.
Result<void> writeFilm(const KeptFilm& kept, std::uint64_t key, const std::filesystem::path& path);
/// As a film of `scene`. Nothing: there is none, it was made from something else, or it is damaged.
std::optional<KeptFilm> readFilm(const Scene& scene, std::uint64_t key, const std::filesystem::path& path);

}  // namespace pdr::app
