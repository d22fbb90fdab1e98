#include "render/film/levels_text.h"

#include <algorithm>
#include <cmath>

namespace pdr {

std::string levelsText(double levels) {
    constexpr double kWholeFrom = 3;
    if (levels >= kWholeFrom)
        return std::to_string(int(std::ceil(levels)));
    const int tenths = std::max(1, int(std::ceil(10 * levels)));
    return tenths % 10 == 0 ? std::to_string(tenths / 10)
                            : std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace pdr
