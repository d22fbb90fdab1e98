#include "render/tiles/node_checks.h"

namespace pdr {

Text checksText(const NodeChecks& checks) {
    if (checks.results == 0)
        return {};
    constexpr int kOneIn = 200;
    return phrase(
        "%1 % of %2 tiles of render nodes were rendered twice; one false tile in %3 would have been found with "
        "a probability of %4 %",
        fixedNumber(100 * checks.share(), 1), checks.results, kOneIn, fixedNumber(100 * checks.foundWith(kOneIn), 0));
}

}  // namespace pdr
