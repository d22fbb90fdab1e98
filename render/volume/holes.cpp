#include "render/volume/holes.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "render/base/text.h"

namespace pdr {
namespace {

constexpr std::string_view kWord = "holes:";
constexpr double kOnSliceMm = 0.02;

/// Reads the number at the front of `text` and what follows it, which must be `behind` or the end of the text, and
/// takes both away.
bool take(std::string_view& text, double& number, char behind) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
        return false;
    text.remove_prefix(std::size_t(end - text.data()));
    if (text.empty())
        return true;
    const bool follows = text.front() == behind;
    text.remove_prefix(1);
    return follows;
}

/// Returns what follows kWord in the remarks, up to the end of the word; empty: no hole is named.
std::string_view listIn(std::string_view remarks) {
    const std::size_t at = remarks.find(kWord);
    if (at == std::string_view::npos)
        return {};
    remarks.remove_prefix(at + kWord.size());
    return remarks.substr(0, remarks.find(' '));
}

}  // namespace

std::string holesRemark(std::span<const HoleHeights> heights) {
    std::string word(kWord);
    for (const HoleHeights& hole : heights) {
        word += word.size() > kWord.size() ? "," : "";
        word += fixedNumber(hole.fromMm, 2) + "-" + fixedNumber(hole.toMm, 2);
    }
    return word;
}

std::vector<Hole> holesOf(const Volume& volume) {
    std::string_view list = listIn(volume.remarks());
    const dmat4& map = volume.geometry().patientFromIndex;
    const dvec3 across = glm::normalize(glm::cross(dvec3(map[0]), dvec3(map[1])));
    const dvec3 normal = glm::dot(across, dvec3(map[2])) < 0 ? -across : across;
    const double lowest = glm::dot(normal, dvec3(map[3]));
    std::vector<Hole> holes;
    for (HoleHeights heights; !list.empty() && take(list, heights.fromMm, '-') && take(list, heights.toMm, ',');)
        holes.push_back({normal, lowest + heights.fromMm, lowest + heights.toMm});
    return holes;
}

bool reachesInto(std::span<const Hole> holes, dvec3 from, dvec3 to) {
    return std::ranges::any_of(holes, [&](const Hole& hole) {
        const auto [low, high] = std::minmax({glm::dot(hole.normal, from), glm::dot(hole.normal, to)});
        return high > hole.fromMm + kOnSliceMm && low < hole.toMm - kOnSliceMm;
    });
}

}  // namespace pdr
