#pragma once
/// Load of a device while it is measured.
///   processor  processor time of all threads of this program over the wall-clock time of as many threads
///   GPU        fraction of the time in which something ran on it, as its driver reports (NVML): a GPU that runs one
///              short program after the other counts as busy, however little of it they fill

#include <memory>
#include <optional>
#include <string>

namespace pdr::bench {

class DeviceLoad {
  public:
    virtual ~DeviceLoad() = default;
    virtual std::string source() const = 0;  ///< name of the source, for the reader of the report
    virtual void start() = 0;
    /// Returns the load since start(), [0, 1]; null if it is not known.
    virtual std::optional<double> stop() = 0;
};

/// Returns `threads`, or the number of cores for 0.
int threadCount(int threads);

/// Returns the load of the CPU by `threads` threads of this program; 0: one per core.
std::unique_ptr<DeviceLoad> processorLoad(int threads);

/// Returns the load of the GPU with that number in the driver's order. It is unknown if there is no driver.
std::unique_ptr<DeviceLoad> gpuLoad(unsigned number);

/// Returns the load of the device that openDevice(name, threads) opens: "cpu", "cuda", "cuda:1".
std::unique_ptr<DeviceLoad> loadOf(const std::string& name, int threads);

}  // namespace pdr::bench
