#pragma once
/// A device that another one replaces if it fails: too old for this program, too full, or broken.

#include <functional>
#include <memory>

#include "render/device/device.h"

namespace pdr {

/// A function that makes the device that takes over.
using Spare = std::function<Result<std::unique_ptr<Device>>()>;
/// A function that is called once with the reason why the other device took over.
using WhySpare = std::function<void(const Error&)>;

/// Returns a device that uses `first` until it fails at a scene, a film or samples, and from then on what `spare`
/// makes. Films move as well and begin anew, which Accumulator::extend() reports; trace() goes on from its sums.
/// Refused and cancelled requests are passed on as errors; so are failures of accumulate() on a film that has samples,
/// and failures of its images. `told` is called on the thread whose request failed, when info() is the spare device's.
std::unique_ptr<Device> withSpare(std::unique_ptr<Device> first, Spare spare, WhySpare told);

}  // namespace pdr
