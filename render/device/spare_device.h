#pragma once
/// A device whose work another one takes over where it fails: too old for this program, too full, or broken.

#include <functional>
#include <memory>

#include "render/device/device.h"

namespace pdr {

/// What makes the device that takes over.
using Spare = std::function<Result<std::unique_ptr<Device>>()>;
/// Is told, once, why the other one took over.
using WhySpare = std::function<void(const Error&)>;

/// `first`, until it fails at an upload, at a film, at samples; then what `spare` makes, for good. Films go over, too,
/// and begin anew: Accumulator::extend() says so. What is refused or cancelled is passed on, and so is a failure of a
/// film's accumulate() that has samples, or of its pictures.
std::unique_ptr<Device> withSpare(std::unique_ptr<Device> first, Spare spare, WhySpare told);

}  // namespace pdr
