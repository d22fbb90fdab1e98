#include "render/device/device_list.h"

namespace pdr {

std::vector<DeviceInfo> devicesHere() {
    return {makeCpuDevice()->info()};
}

Result<std::unique_ptr<Device>> openDevice(const std::string& name, int threads) {
    if (name == "cpu" || name == "auto")
        return makeCpuDevice(threads);
    return Error{"there is no such device", name, "Choose cpu."};
}

}  // namespace pdr
