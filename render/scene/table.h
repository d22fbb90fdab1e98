#pragma once

namespace pdr {

/// Whether the scanner's table, the head holder and everything else outside the body are part of the image.
enum class Table { shown, hidden };

}  // namespace pdr
