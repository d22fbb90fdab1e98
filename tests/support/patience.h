#pragma once

namespace pdr::test {

/// Milliseconds that a test waits for what must come: a machine that many share may take its time, and what hangs is
/// ended all the same.
inline constexpr int kPatience = 1'800'000;

}  // namespace pdr::test
