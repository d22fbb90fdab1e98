#pragma once
/// Writes how often each part of each kernel was run, for tools/measure/gpu_instructions.py.

#include <string>

namespace pdr::ptx {

class Kernels;

/// Writes the PTX of each module that has kernels to `folder`/NUMBER.ptx, and a text to `folder`/counts.txt: a line
/// "kernel NAME MODULE LAUNCHES" for each kernel, and behind it, for each block of its instructions that has run,
/// "block FIRST LAST STATEMENTS WARPS LANES": lines of the module's text, statements in them, how often warps ran them,
/// and the sum of their busy lanes. Ends the program with code 3 where the folder cannot be written to.
void writeCounts(const std::string& folder, const Kernels& kernels);

}  // namespace pdr::ptx
