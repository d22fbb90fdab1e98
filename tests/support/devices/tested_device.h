#pragma once
/// The device that tests render with: the CPU, or the one that the environment variable PDR_TEST_DEVICE names.

#include <cstdlib>
#include <iostream>

#include "render/device/device_list.h"

namespace pdr::test {

inline std::unique_ptr<Device> testedDevice() {
    const char* name = std::getenv("PDR_TEST_DEVICE");
    Result<std::unique_ptr<Device>> device = openDevice(name != nullptr ? name : "cpu");
    if (!device) {
        std::cerr << device.error().text() << '\n';
        std::exit(1);
    }
    return *std::move(device);
}

}  // namespace pdr::test
