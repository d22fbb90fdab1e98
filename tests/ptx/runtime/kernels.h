#pragma once
/// The kernels of the program that this library is linked with, as nvcc's code registers them.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/ptx/machine/launch.h"
#include "tests/ptx/text/fat_binary.h"

namespace pdr::ptx {

/// What nvcc has embedded of an object file.
struct EmbeddedModule {
    std::vector<EmbeddedCode> code;
    std::optional<Module> text;  ///< the PTX, once it was needed

    /// Returns the text of its PTX. Throws NotKnown where there is none.
    const std::string& ptxText() const;
    /// Throws NotKnown where there is no PTX.
    const Module& ptx();
};

struct Kernel {
    EmbeddedModule* module;
    std::string name;                  ///< mangled
    std::unique_ptr<Program> program;  ///< once it was needed
    std::vector<Warp> warps;           ///< registers of its last launch
    std::vector<BlockCounts> counts;   ///< by the program's blocks, of all launches
    u64 launches = 0;
    bool isPrepared = false;  ///< its attributes were asked for, so that a driver has translated it

    /// Decodes the kernel at the first call. Throws NotKnown.
    const Program& decoded(const Settings& settings);
    /// Returns whether a device of that capability has code to run: machine code of its generation, or PTX not newer.
    bool runsOn(int capability) const;
    /// Returns the registers of a thread by the machine code; 0: there is none.
    int registers() const;
    /// Returns how many blocks a multiprocessor of an H200 holds, which has 65,536 registers and 2048 threads.
    int blocksPerProcessor(int threads) const;
};

class Kernels {
  public:
    EmbeddedModule& addModule(std::vector<EmbeddedCode> code);
    void add(const void* host, EmbeddedModule& module, const char* name);
    /// Returns the kernel that nvcc's function `host` launches, or null.
    Kernel* find(const void* host);

    std::map<const void*, Kernel>& all() { return byHost_; }
    const std::map<const void*, Kernel>& all() const { return byHost_; }

  private:
    std::vector<std::unique_ptr<EmbeddedModule>> modules_;
    std::map<const void*, Kernel> byHost_;
};

}  // namespace pdr::ptx
