#include "render/film/display_error.h"

#include <iterator>
#include <numeric>

namespace pdr {

double errorQuantile(const ErrorCounts& counts, double fraction) {
    const double all = std::accumulate(std::begin(counts.pixels), std::end(counts.pixels), 0.0);
    double left = fraction * all;
    for (int bin = 0; bin < kErrorBins; ++bin) {
        const double here = counts.pixels[bin];
        if (here > 0 && here >= left)
            return bin == 0 ? 0 : glm::mix(errorBinBegin(bin), errorBinBegin(bin + 1), left / here);
        left -= here;
    }
    return all > 0 ? 255 : 0;
}

}  // namespace pdr
