#pragma once
/// Wrapper of a device that measures the processor time of the samples of an image. The rest of the program's time goes
/// into display and into statements of accuracy.

#include <atomic>
#include <memory>

#include "render/device/device.h"

namespace pdr::bench {

/// Data that comes with an image.
enum class Told {
    nothing,  ///< only the bytes for the screen
    status    ///< bytes and status; never denoised, which would be another image and not a matter of accuracy
};

/// Processor times [s]; may be read on any thread.
struct Meter {
    std::atomic<double> samples = 0;  ///< samples of whole images
    std::atomic<double> parts = 0;    ///< samples of parts of an image, and uploads: the work that measures the bias
};

/// Wraps `device`, which must be a CPU device. `meter` must outlive the result.
std::unique_ptr<Device> meteredDevice(std::unique_ptr<Device> device, Told told, Meter& meter);

}  // namespace pdr::bench
