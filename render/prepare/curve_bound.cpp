#include "render/prepare/curve_bound.h"

#include <algorithm>

namespace pdr {

void CurveBound::over(const HuRange* ranges, float* __restrict bounds, int count) const {
    for (int i = 0; i < count; ++i)
        bounds[i] = over(ranges[i]);
}

std::vector<CurveBound> curveBounds(const FlatTransferFunction& common, const FlatParts& parts, HuRange domain) {
    std::vector<CurveBound> bounds;
    bounds.reserve(std::size_t(std::max(parts.curveCount, 1)));
    for (int i = 0; i < parts.curveCount; ++i)
        bounds.emplace_back(parts.curves[i], domain);
    if (bounds.empty())
        bounds.emplace_back(common, domain);
    return bounds;
}

}  // namespace pdr
