#pragma once
/// Films that several machines have rendered for one image, put together.

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/batch/film_file.h"

namespace pdr::app {

/// Reads films, in any order, and returns all their shares as one. The result is the same for any order, and for films
/// that were joined before. Errors, which name the file: those of readFilm(); a film that is not of the first one's
/// image, with what differs; a share that is there twice.
Result<SavedFilm> joinedFilms(const std::vector<std::filesystem::path>& files);

/// Checks that all shares of the image are there. Error: some are missing, with their numbers.
Result<void> checkComplete(const SavedFilm& saved);

/// Returns in what the image of `other` differs from that of `one`: "another seed". Empty: in nothing.
std::string differenceOf(const FilmOrigin& one, const FilmOrigin& other);

}  // namespace pdr::app
