#include "render/slice/slice_letters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pdr {

std::string orientationLetters(dvec3 direction) {
    constexpr double kNamed = 0.1736;  // sine of 10 degrees; smaller components have no letter
    constexpr std::array kAlong{'L', 'P', 'H'};
    constexpr std::array kAgainst{'R', 'A', 'F'};

    const dvec3 unit = glm::normalize(direction);
    std::array axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return std::abs(unit[a]) > std::abs(unit[b]); });
    std::string letters;
    for (const int axis : axes) {
        if (std::abs(unit[axis]) >= kNamed)
            letters += unit[axis] > 0 ? kAlong[std::size_t(axis)] : kAgainst[std::size_t(axis)];
    }
    return letters;
}

EdgeLetters edgeLetters(dvec3 right, dvec3 down) {
    return {orientationLetters(-right), orientationLetters(right), orientationLetters(-down), orientationLetters(down)};
}

}  // namespace pdr
