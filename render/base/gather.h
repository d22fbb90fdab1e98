#pragma once
/// Whether the processor's gather instruction, which reads from 16 (or 8) addresses at once, is faster than single
/// loads. It is up to 1.4 times as fast; where the microcode guards it (Intel's "Downfall", 2023) it is several times
/// slower. The values that are read are the same.

namespace pdr {

/// Whether gather instructions are used. Measured when the program starts, which takes about 0.1 ms.
extern const bool kGatherAtOnce;

}  // namespace pdr
