#pragma once
/// Time that this program has spent on all processors, without other programs.

#include <ctime>

namespace pdr::test {

class ProcessorTime {
  public:
    /// Processor time since this object was made.
    double seconds() const { return double(std::clock() - start_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t start_ = std::clock();
};

}  // namespace pdr::test
