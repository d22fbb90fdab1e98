#pragma once
/// The numbers that volume files hold, and their bytes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace pdr {

enum class SampleType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Returns the size of one sample [bytes].
std::size_t bytesOf(SampleType type);

/// Converts samples as they lie in a file; `bytes` holds values.size() of them. Whole numbers beyond 2^53 are rounded.
void decodeSamples(SampleType type, bool isBigEndian, std::span<const std::uint8_t> bytes, std::span<double> values);

}  // namespace pdr
