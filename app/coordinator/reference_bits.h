#pragma once
/// Identifies the determinism class of a machine, which coordinator and node compare in the handshake.

#include <vector>

#include "app/wire/messages.h"

namespace pdr::nodes {

/// Returns the hash of the result of referenceTiles().
wire::Hash bitsOf(const std::vector<std::byte>& referenceTiles);

}  // namespace pdr::nodes
