#include "app/cli/accuracy/kept_film.h"

namespace pdr::app {

Result<void> keepFilm(const KeptFilm& kept, FilmOrigin origin, const std::filesystem::path& path) {
    origin.samples = kept.film->samplesPerPixel();
    return writeFilm(savedFilm(*kept.film, origin, kept.seconds), path);
}

std::optional<KeptFilm> keptFilm(FilmOrigin origin, std::uint64_t revision, const std::filesystem::path& path) {
    const auto saved = readFilm(path);
    if (!saved)
        return std::nullopt;
    origin.samples = saved->origin.samples;
    if (saved->origin != origin)
        return std::nullopt;
    return KeptFilm{wholeFilm(*saved, revision), saved->shares.front().seconds};
}

}  // namespace pdr::app
