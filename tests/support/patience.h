#pragma once
/// Time limit for tests that wait.

namespace pdr::test {

/// Time that a test waits for an expected event [ms]: long enough for a busy machine, and a test that hangs still ends.
inline constexpr int kPatience = 1'800'000;

}  // namespace pdr::test
