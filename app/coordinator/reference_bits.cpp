#include "app/coordinator/reference_bits.h"

#include <array>

#include "app/wire/content_hash.h"

namespace pdr::nodes {

wire::Hash bitsOf(const std::vector<std::byte>& referenceTiles) {
    return wire::contentHash(std::array{std::byte{'b'}, std::byte{'i'}, std::byte{'t'}, std::byte{'s'}},
                             referenceTiles);
}

}  // namespace pdr::nodes
