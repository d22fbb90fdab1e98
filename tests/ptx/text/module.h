#pragma once
/// A module of PTX: the kernels of one object file.

#include <map>
#include <string>
#include <vector>

#include "tests/ptx/text/declaration.h"
#include "tests/ptx/text/statement.h"

namespace pdr::ptx {

struct Parameter {
    std::string name;
    u32 offset, bytes;
};

/// What is declared and stated in a kernel.
struct KernelText {
    std::string name;
    std::vector<Parameter> parameters;
    u32 parameterBytes = 0;
    std::vector<RegisterSet> registers;
    std::map<std::string, u32> locals;  ///< where each variable lies in a thread's local memory
    u32 localBytes = 0;
    std::vector<Statement> statements;
};

class Module {
  public:
    explicit Module(std::string text);

    /// Returns the names of all kernels, in the order of the alphabet.
    std::vector<std::string> kernels() const;
    /// Returns a kernel that is in the module. Throws NotKnown at a directive that it does not know.
    KernelText kernel(const std::string& name) const;

  private:
    std::string text_;
    std::map<std::string, std::size_t> at_;  ///< where the parameters of each begin
};

}  // namespace pdr::ptx
