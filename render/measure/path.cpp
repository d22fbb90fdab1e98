#include "render/measure/path.h"

#include <cmath>
#include <vector>

#include "render/measure/line.h"

namespace pdr::measure {
namespace {

constexpr double kShortestSigmas = 10;

}  // namespace

Result<Stated> pathLength(std::span<const Place> places) {
    if (places.size() < 2)
        return Error{phrase("a path has at least two places"), "", "", ErrorKind::refused};
    double length = 0;
    std::vector<dvec3> gradients(places.size(), dvec3(0));
    for (std::size_t n = 1; n < places.size(); ++n) {
        const Line step(places[n - 1], places[n]);
        const double sigma = std::sqrt(step.varianceAcross() / 4);  // of one end in one direction across
        if (step.lengthMm == 0 || step.lengthMm < kShortestSigmas * sigma)
            return Error{phrase("places %1 and %2 of the path are too close for how well they are known", n, n + 1), "",
                         phrase("Leave one of them out."), ErrorKind::refused};
        length += step.lengthMm - step.lengtheningMm();
        gradients[n - 1] -= step.direction;
        gradients[n] += step.direction;
    }
    return propagated(length, places, gradients, 0, INFINITY);
}

}  // namespace pdr::measure
