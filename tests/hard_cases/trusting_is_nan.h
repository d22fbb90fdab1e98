#pragma once

namespace pdr::test {

/// Whether x is no number, as a compiler sees it that was told that there is none (-ffinite-math-only).
bool trustingIsNan(float x);

}  // namespace pdr::test
