#pragma once
/// 32 lanes in step: their registers, and where each of them is.

#include <random>
#include <span>
#include <string>
#include <vector>

#include "tests/ptx/base/findings.h"
#include "tests/ptx/base/settings.h"
#include "tests/ptx/code/program.h"
#include "tests/ptx/machine/device_memory.h"
#include "tests/ptx/machine/texture.h"

namespace pdr::ptx {

struct Size3 {
    u32 x = 1, y = 1, z = 1;
    u64 count() const { return u64(x) * y * z; }
};

/// How often warps have run a block of instructions, and of how many lanes in all.
struct BlockCounts {
    u64 warps = 0, lanes = 0;
};

/// A launch that is under way.
struct Launch {
    const Program& program;
    std::vector<BlockCounts>& counts;  ///< by the program's blocks
    const Settings& settings;
    DeviceMemory& memory;
    const Textures& textures;
    Garbage& garbage;
    Findings& findings;
    std::span<u8> parameters;
    Size3 grid, block;
    u32 number;  ///< from 1
    std::minstd_rand random;
    TouchedMemory touched;
};

struct Warp {
    /// Lanes at the same place.
    struct Group {
        u32 block, mask;
    };

    Launch* launch = nullptr;
    std::vector<u8> fileMemory;
    u8* file = nullptr;           ///< registers, see Instruction
    std::vector<u32> predicates;  ///< a bit for each lane
    std::vector<u8> local;        ///< local memory, one lane's behind the other's
    std::vector<Group> groups;    ///< the lowest order of their blocks first
    u32 mask = 0;                 ///< lanes that take part in an instruction
    u32 firstThread = 0;          ///< number of lane 0's thread in the launch

    /// Gets registers and constants for a launch; keeps them from one launch of a program to the next.
    void prepare(Launch& ofLaunch);
    /// Begins with warp number `index` of the block of threads `block`.
    void start(u64 block, u32 index);
    /// Runs at most so many blocks of instructions. Returns false once all lanes have ended. Throws DeviceFault.
    bool run(int blocks);

    template <class T>
    T* at(u32 slot) {
        return reinterpret_cast<T*>(file + slot);
    }
    void setPredicate(u32 number, u32 bits) { predicates[number] = (predicates[number] & ~mask) | (bits & mask); }
    Accessor accessor(int lane) const { return {launch->number, firstThread + u32(lane)}; }
    [[noreturn]] void fault(const Instruction& i, int lane, int status, const std::string& what) const;
    void tell(const Instruction& i, const std::string& what) const;

  private:
    std::string placeOf(const Instruction& i) const;
    std::size_t nextGroup();
    void enter(u32 block, u32 lanes);
    void leave(const Block& block, u32 number);
    void runBlock(const Block& block);
};

}  // namespace pdr::ptx
