#include "render/device/cuda/embedded_code.h"

#include <algorithm>

namespace pdr {

bool hasMachineCodeFor(int major, int minor) {
    static constexpr int kEmbedded[] = {PDR_CUDA_CODE};
    return std::ranges::any_of(kEmbedded, [&](int code) { return code / 10 == major && code % 10 <= minor; });
}

}  // namespace pdr
