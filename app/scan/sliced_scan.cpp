#include "app/scan/sliced_scan.h"

namespace pdr::app {

std::optional<SliceImage> reslice(const SlicedScan& scan, const SlicePlane& plane, const std::stop_token& stop,
                                  std::vector<float> memory) {
    if (scan.volume())
        return pdr::reslice(*scan.volume(), plane, {}, stop, std::move(memory));
    return pdr::reslice(*scan.arriving(), plane, stop, std::move(memory));
}

}  // namespace pdr::app
