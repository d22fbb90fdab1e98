#pragma once
/// What this program has spent on all processors: what other programs take does not count.

#include <ctime>

namespace pdr::test {

class ProcessorTime {
  public:
    /// Since this value was made.
    double seconds() const { return double(std::clock() - start_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t start_ = std::clock();
};

}  // namespace pdr::test
