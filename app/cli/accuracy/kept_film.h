#pragma once
/// The reference of a report, kept in its folder between two runs.

#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/batch/film_file.h"
#include "render/film/film.h"

namespace pdr::app {

struct KeptFilm {
    std::shared_ptr<const Film> film;
    double seconds = 0;  ///< rendering time of the film
};

/// Writes `kept`, a whole image of `origin`, to `path`; all its pixels have the same number of samples. Errors: those
/// of files.
Result<void> keepFilm(const KeptFilm& kept, FilmOrigin origin, const std::filesystem::path& path);
/// Reads the file at `path` as a film of `origin`, whatever its number of samples. Null if there is none, if it was
/// made from something else, or if it is damaged.
std::optional<KeptFilm> keptFilm(FilmOrigin origin, std::uint64_t revision, const std::filesystem::path& path);

}  // namespace pdr::app
