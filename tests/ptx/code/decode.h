#pragma once
/// Makes a program of a kernel's text.

#include <memory>

#include "tests/ptx/code/program.h"

namespace pdr::ptx {

/// `byAddress`: where lanes have parted, those at the lowest address go first; else, as early as can be, they meet
/// again. Throws NotKnown at an instruction, an operand or a directive that this library does not know.
std::unique_ptr<Program> decode(const KernelText& text, bool byAddress);

}  // namespace pdr::ptx
