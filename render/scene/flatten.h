#pragma once
/// The only builder of kernel tables.

#include <memory>

namespace pdr {

struct PreparedScene;

}  // namespace pdr
