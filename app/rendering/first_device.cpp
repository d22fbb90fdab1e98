#include "app/rendering/first_device.h"

#include <utility>

#include "render/device/device_list.h"

namespace pdr::app {

Result<FirstDevice> firstDevice(const std::string& asked, const std::string& last, int threads,
                                const PreparationObserver& preparing) {
    FirstDevice first;
    const auto open = [&](const std::string& name) -> Result<void> {
        const WhySpare whyCpu = [&](const Error& why) {
            first.notice = phrase("The CPU renders, since the GPU cannot be used: %1", why.text());
        };
        auto device = openDevice(name, threads, whyCpu, preparing);
        if (!device)
            return device.error();
        first.device = *std::move(device);
        return {};
    };
    const Result<void> wanted = open(asked.empty() ? last : asked);
    if (wanted)
        return first;
    if (!asked.empty())
        return wanted.error();
    if (const Result<void> opened = open("auto"); !opened)
        return opened.error();
    const DeviceInfo best = first.device->info();
    const Text why = wanted.error().text();
    first.notice = best.hostMemory
                       ? phrase("The CPU renders, since the device chosen last cannot be used: %1", why)
                       : phrase("The GPU %1 renders, since the device chosen last cannot be used: %2", best.name, why);
    return first;
}

}  // namespace pdr::app
