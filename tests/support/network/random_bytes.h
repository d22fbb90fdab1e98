#pragma once
/// Random bytes, which have no meaning and cannot be compressed.

#include <cstddef>
#include <random>
#include <vector>

namespace pdr::test {

inline std::vector<std::byte> randomBytes(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::byte> bytes(count);
    for (std::byte& byte : bytes)
        byte = std::byte(random());
    return bytes;
}

}  // namespace pdr::test
