#pragma once
/// The determinism class of a machine, as coordinator and node compare it in the handshake.

#include <vector>

#include "app/wire/messages.h"

namespace pdr::nodes {

/// Hash of the result of referenceTiles().
wire::Hash bitsOf(const std::vector<std::byte>& referenceTiles);

}  // namespace pdr::nodes
