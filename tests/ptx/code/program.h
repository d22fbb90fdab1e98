#pragma once
/// A kernel, decoded: instructions for 32 lanes at a time, in blocks that are entered at their beginning only.

#include <string>
#include <utility>
#include <vector>

#include "tests/ptx/code/instruction.h"
#include "tests/ptx/text/module.h"

namespace pdr::ptx {

struct Block {
    enum class End : u8 { next, jump, branch, exit };
    u32 first, last;                  ///< instructions [first, last)
    u32 firstLine = 0, lastLine = 0;  ///< lines of the module's text, those of a branch that ends it included
    u32 statements = 0;               ///< instructions and that branch
    End end = End::next;
    u32 predicate = kNone;  ///< predicate that a branch asks
    bool predicateNot = false;
    bool exits = false;      ///< lanes that take the branch leave the kernel
    u32 target = kNone;      ///< block that is jumped to
    u32 order = 0;           ///< where lanes have parted, those at the block with the lowest go first
    u32 memberMask = kNone;  ///< slot of the lanes that must come together here; kNone: each for itself
};

/// A constant operand.
struct Constant {
    u32 slot, bytes;
    u64 bits;
    bool isParameter = false;  ///< the address of a parameter is meant; bits: its offset
};

struct SpecialRegister {
    std::string name;  ///< "%tid.x"
    u32 slot;
};

struct Program {
    KernelText text;
    std::vector<Instruction> instructions;
    std::vector<Block> blocks;
    u32 fileBytes = 0;   ///< size of a warp's register file
    u32 predicates = 0;  ///< count
    std::vector<Constant> constants;
    std::vector<std::pair<u32, bool>> constantPredicates;
    std::vector<SpecialRegister> specials;
};

}  // namespace pdr::ptx
