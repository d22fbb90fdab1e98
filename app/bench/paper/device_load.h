#pragma once
/// How busy a device is while it is measured.
///   processor  the time that all threads of this program spent on it, over the clock's time that so many threads had
///   GPU        the fraction of time in which something ran on it, as its driver says (NVML): a GPU with one short
///   program
///              after the other counts as busy, however little of it they fill

#include <memory>
#include <optional>
#include <string>

namespace pdr::bench {

class DeviceLoad {
  public:
    virtual ~DeviceLoad() = default;
    virtual std::string source() const = 0;  ///< for the reader of the report
    virtual void start() = 0;
    /// Since start(), [0, 1]; nothing where it cannot be known.
    virtual std::optional<double> stop() = 0;
};

/// `threads`, or one per core for 0.
int threadCount(int threads);

/// `threads` of this program do the work; 0 = one per core.
std::unique_ptr<DeviceLoad> processorLoad(int threads);

/// The GPU of that number, counted as the driver counts. Knows nothing where there is no driver.
std::unique_ptr<DeviceLoad> gpuLoad(unsigned number);

/// Of the device that openDevice(name, threads) opens: "cpu", "cuda", "cuda:1".
std::unique_ptr<DeviceLoad> loadOf(const std::string& name, int threads);

}  // namespace pdr::bench
