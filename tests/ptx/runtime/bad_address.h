#pragma once
/// What happens where the host follows an address that is not its own.

namespace pdr::ptx {

/// From now on the program ends with code 139 there, and says whether the address is the device's, or of pinned memory
/// that a copy still waits for.
void tellBadAddresses();

}  // namespace pdr::ptx
