#pragma once
/// One instruction, decoded: a function and where its numbers lie.

#include <array>
#include <string>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

struct Warp;
struct Instruction;
/// Carries an instruction out for the lanes of warp.mask.
using Operation = void (*)(Warp&, const Instruction&);

/// A slot that is not there. Slots are places in a warp's register file: 32 numbers of 4 or 8 bytes each. Predicates
/// have numbers instead, of masks in an array of their own.
inline constexpr u32 kNone = ~0u;

struct Instruction {
    Operation run = nullptr;
    std::array<u32, 4> to{kNone, kNone, kNone, kNone};           ///< slots of the results
    std::array<u32, 5> from{kNone, kNone, kNone, kNone, kNone};  ///< slots of the operands
    s64 offset = 0;                                              ///< added to an address
    u32 guard = kNone;                                           ///< predicate that lanes need to take part
    bool guardNot = false;                                       ///< they need it to be false
    u8 bytes = 0;                                                ///< size of one element that is loaded or stored
    u8 count = 1;                                                ///< elements
    bool isVolatile = false;
    u32 line = 0;  ///< line of the module's text, from 1
    std::string text;
};

}  // namespace pdr::ptx
