#pragma once
/// The class of machines that make the same bits, as coordinator and nodes tell it each other.

#include <vector>

#include "app/wire/messages.h"

namespace pdr::nodes {

/// Of what referenceTiles() found.
wire::Hash bitsOf(const std::vector<std::byte>& referenceTiles);

}  // namespace pdr::nodes
