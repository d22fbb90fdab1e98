#pragma once
/// What goes wrong in a run: faults of the program that runs, which are told, and what this library does not know.

#include <set>
#include <stdexcept>
#include <string>

namespace pdr::ptx {

/// PTX, or a call of the runtime, that this library does not know: its own shortcoming, not a fault of the program's.
struct NotKnown : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What ends a launch on a real GPU, and the context with it.
struct DeviceFault : std::runtime_error {
    int status;  ///< a cudaError_t
    DeviceFault(int status, const std::string& what) : std::runtime_error(what), status(status) {}
};

/// Faults that a run has shown. Each text is written to standard error once, behind "ptx: ".
class Findings {
  public:
    void tell(const std::string& text);

  private:
    std::set<std::string> told_;
};

}  // namespace pdr::ptx
