#pragma once

namespace pdr::test {

/// Returns whether x is no number, as compiled under the assumption that there is none (-ffinite-math-only).
bool trustingIsNan(float x);

}  // namespace pdr::test
