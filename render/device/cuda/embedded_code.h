#pragma once
/// The machine code for GPUs that this program holds.

namespace pdr {

/// Returns whether GPUs of the compute capability `major`.`minor` run the machine code that is embedded: code of the
/// same major number and no higher minor one (CUDA C++ Programming Guide, "Binary Compatibility"). Drivers of others
/// translate PTX.
bool hasMachineCodeFor(int major, int minor);

}  // namespace pdr
