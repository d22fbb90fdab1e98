#pragma once
/// Numbers of which IEEE 754 and PTX say more than the usual: computed by the PTX and by the host.

namespace pdr::ptx {

/// Computes with all combinations of zeros, subnormal, infinite and other odd numbers, and prints how many differ.
/// Returns whether any does.
bool arithmeticDiffers();

}  // namespace pdr::ptx
