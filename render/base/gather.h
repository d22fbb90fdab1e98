#pragma once
/// Whether the processor's instruction that reads from 16 (or 8) addresses at once is worth it. It is up to 1.4 times
/// as fast as loads one by one; where the microcode guards it (Intel's "Downfall", 2023) it is several times slower.
/// What is read is the same.

namespace pdr {

/// Measured when the program starts; it takes about 0.1 ms.
extern const bool kGatherAtOnce;

}  // namespace pdr
