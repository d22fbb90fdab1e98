#include "render/film/levels_text.h"

#include <algorithm>
#include <cmath>

namespace pdr {

Text levelsText(double levels) {
    constexpr double kWholeFrom = 3;
    if (levels >= kWholeFrom)
        return Text(int(std::ceil(levels)));
    const int tenths = std::max(1, int(std::ceil(10 * levels)));
    return tenths % 10 == 0 ? Text(tenths / 10) : fixedNumber(tenths / 10.0, 1);
}

}  // namespace pdr
