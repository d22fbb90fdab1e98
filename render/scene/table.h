#pragma once

namespace pdr {

/// Whether the scanner's table, the head holder, and all else outside the body is part of the picture.
enum class Table { shown, hidden };

}  // namespace pdr
