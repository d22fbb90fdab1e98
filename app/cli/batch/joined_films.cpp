#include "app/cli/batch/joined_films.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace pdr::app {
namespace {

/// Returns "3, 7 to 9 and 40 more": where much is missing, the beginning says enough.
std::string numbersText(const std::vector<int>& numbers) {
    constexpr std::size_t kMostNamed = 8;
    std::string text;
    std::size_t named = 0, i = 0;
    while (i < numbers.size() && named < kMostNamed) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
        if (last > i)
            text += " to " + std::to_string(numbers[last]);
        i = last + 1;
        ++named;
    }
    return i < numbers.size() ? text + " and " + std::to_string(numbers.size() - i) + " more" : text;
}

}  // namespace

std::string differenceOf(const FilmOrigin& one, const FilmOrigin& other) {
    if (one.program != other.program)
        return "another version of PD-Render";
    if (one.bits != other.bits)
        return "a device or a build that takes other samples";
    if (one.size != other.size)
        return "another size";
    if (one.samples != other.samples)
        return "another number of samples";
    if (one.shares != other.shares)
        return "another number of shares";
    if (one.seed != other.seed)
        return "another seed";
    if (one.voxels != other.voxels)
        return "another scan";
    return one == other ? "" : "another scene";
}

Result<SavedFilm> joinedFilms(const std::vector<std::filesystem::path>& files) {
    SavedFilm all;
    std::map<int, std::pair<FilmShare, std::filesystem::path>> shares;
    for (const std::filesystem::path& file : files) {
        auto film = readFilm(file);
        if (!film)
            return film.error();
        if (shares.empty())
            all.origin = film->origin;
        if (const std::string difference = differenceOf(all.origin, film->origin); !difference.empty())
            return Error{"this film is from " + difference + ", compared with " + files.front().string(), file.string(),
                         "Render all shares with the same options."};
        for (FilmShare& share : film->shares) {
            const int number = share.number;
            const auto [at, isNew] = shares.try_emplace(number, std::move(share), file);
            if (!isNew)
                return Error{"share " + std::to_string(number) + " is in " + at->second.second.string() + ", too",
                             file.string(), "Name each share once."};
        }
    }
    for (auto& [number, share] : shares)
        all.shares.push_back(std::move(share.first));
    return all;
}

Result<void> checkComplete(const SavedFilm& saved) {
    std::vector<int> missing;
    auto next = saved.shares.begin();
    for (int number = 1; number <= saved.origin.shares; ++number)
        if (next != saved.shares.end() && next->number == number)
            ++next;
        else
            missing.push_back(number);
    if (missing.empty())
        return {};
    return Error{std::to_string(missing.size()) + " of " + std::to_string(saved.origin.shares) +
                     " shares are missing: " + numbersText(missing),
                 "", "Render them, and name their files, too."};
}

}  // namespace pdr::app
