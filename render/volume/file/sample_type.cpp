#include "render/volume/file/sample_type.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace pdr {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are turned to little endian");

template <class T>
void decodeAs(bool isBigEndian, const std::uint8_t* bytes, std::span<double> values) {
    std::array<std::uint8_t, sizeof(T)> sample;
    for (double& value : values) {
        std::memcpy(sample.data(), bytes, sizeof(T));
        if (isBigEndian)
            std::ranges::reverse(sample);
        value = double(std::bit_cast<T>(sample));
        bytes += sizeof(T);
    }
}

/// Calls `use` with a value of the C++ type of `type`.
template <class Use>
auto withType(SampleType type, Use use) {
    switch (type) {
        case SampleType::int8:
            return use(std::int8_t{});
        case SampleType::uint8:
            return use(std::uint8_t{});
        case SampleType::int16:
            return use(std::int16_t{});
        case SampleType::uint16:
            return use(std::uint16_t{});
        case SampleType::int32:
            return use(std::int32_t{});
        case SampleType::uint32:
            return use(std::uint32_t{});
        case SampleType::int64:
            return use(std::int64_t{});
        case SampleType::uint64:
            return use(std::uint64_t{});
        case SampleType::float32:
            return use(float{});
        case SampleType::float64:
            break;
    }
    return use(double{});
}

}  // namespace

std::size_t bytesOf(SampleType type) {
    return withType(type, [](auto sample) { return sizeof sample; });
}

void decodeSamples(SampleType type, bool isBigEndian, std::span<const std::uint8_t> bytes, std::span<double> values) {
    withType(type, [&](auto sample) { decodeAs<decltype(sample)>(isBigEndian, bytes.data(), values); });
}

}  // namespace pdr
