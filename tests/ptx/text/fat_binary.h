#pragma once
/// The fat binaries that nvcc embeds in a program: PTX and machine code of a module for each architecture.

#include <string>
#include <vector>

namespace pdr::ptx {

struct EmbeddedCode {
    bool isPtx;        ///< else machine code: a cubin, an ELF file
    int architecture;  ///< 75: compute_75 or sm_75
    std::string content;
};

/// Returns all code of a module. `image`: where the wrapper that __cudaRegisterFatBinary gets points to. Throws
/// NotKnown where it is not laid out as nvcc 13 does.
std::vector<EmbeddedCode> embeddedCode(const void* image);

/// Returns how many registers a thread of `kernel` has by the cubin; 0: the kernel is not in it.
int registersIn(const std::string& cubin, const std::string& kernel);

}  // namespace pdr::ptx
