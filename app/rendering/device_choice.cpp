#include "app/rendering/device_choice.h"

#include <utility>

#include "render/tiles/reference_tiles.h"

namespace pdr::app {
namespace {

/// Returns the device `name`, or the CPU if that cannot be opened or fails later. `told` gets the reason.
std::unique_ptr<Device> openOrCpu(const std::string& name, int threads, const WhySpare& told) {
    Result<std::unique_ptr<Device>> device = openDevice(name, threads);
    if (device)
        return withCpuAsSpare(*std::move(device), threads, told);
    told(device.error());
    return makeCpuDevice(threads);
}

}  // namespace

bool DeviceChoice::setPool(const std::shared_ptr<SharedWork>& pool) {
    const std::lock_guard lock(mutex_);
    return std::exchange(pool_, pool) != pool;
}

Result<std::unique_ptr<Device>> DeviceChoice::open(const std::string& name) {
    Result<std::unique_ptr<Device>> opened = openDevice(name, threads_, {}, preparing_);
    if (!opened)
        return opened;
    return shared(*std::move(opened));
}

/// Returns `device`, shared with the workers if there are any.
Result<std::unique_ptr<Device>> DeviceChoice::shared(std::unique_ptr<Device> device) {
    std::shared_ptr<SharedWork> pool;
    {
        const std::lock_guard lock(mutex_);
        pool = pool_;
    }
    if (!pool)
        return device;
    Result<std::vector<std::byte>> bits = referenceTiles(*device);
    if (!bits)
        return bits.error();
    {
        const std::lock_guard lock(mutex_);
        bits_ = *bits;
    }
    QMetaObject::invokeMethod(this, [this, bits = *std::move(bits)] { emit sharedWith(bits); });
    return shareDevice(std::move(device), std::move(pool));
}

DeviceOpener DeviceChoice::cpuAlone() const {
    return [threads = threads_]() -> Result<std::unique_ptr<Device>> { return makeCpuDevice(threads); };
}

DeviceOpener DeviceChoice::forFinalRender(std::string name, WhySpare told) const {
    const std::lock_guard lock(mutex_);
    return [name = std::move(name), told = std::move(told), threads = threads_, pool = pool_,
            bits = bits_]() -> Result<std::unique_ptr<Device>> {
        std::unique_ptr<Device> device = openOrCpu(name, threads, told);
        if (!pool)
            return device;
        const Result<std::vector<std::byte>> own = referenceTiles(*device);
        if (!own || *own != bits)
            return device;
        return shareDevice(std::move(device), pool, Purpose::finalRender);
    };
}

std::function<NodeChecks()> DeviceChoice::nodeChecks() const {
    const std::lock_guard lock(mutex_);
    return [pool = pool_] { return pool ? pool->checks() : NodeChecks(); };
}

}  // namespace pdr::app
