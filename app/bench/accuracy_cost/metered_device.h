#pragma once
/// A device as it is, that tells how much processor time the samples of its picture took; what else the program takes
/// goes into showing it and into saying how right it is.

#include <atomic>
#include <memory>

#include "render/device/device.h"

namespace pdr::bench {

/// What pictures come with.
enum class Told {
    nothing,  ///< the bytes for the screen alone
    status    ///< these and their status. Never smoothed: that is no accuracy, but another picture
};

/// Processor time [s]; read on any thread.
struct Meter {
    std::atomic<double> samples = 0;  ///< of whole pictures
    std::atomic<double> parts = 0;    ///< of parts of them, and of taking scenes up: what measures their bias
};

/// `device`, a CPU's; `meter` must outlive it.
std::unique_ptr<Device> meteredDevice(std::unique_ptr<Device> device, Told told, Meter& meter);

}  // namespace pdr::bench
