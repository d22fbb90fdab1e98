#pragma once
/// Declarations of PTX: parameters, local variables, registers.

#include <string>
#include <string_view>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

/// A variable: ".align 4 .b8 name[108]".
struct Declaration {
    std::string name;
    u32 align, bytes;

    /// Returns where it lies behind `used` bytes, and adds to these.
    u32 placeBehind(u32& used) const;
};
/// `text` begins with the first attribute. Those that say nothing about place or size are passed over.
Declaration declarationIn(std::string_view text);

struct RegisterSet {
    std::string type;    ///< "f32"
    std::string prefix;  ///< "%f"
    u32 count;           ///< 0: one register, of that very name
};
/// A set of ".reg .f32 %f<10>". `text`: "%f<10>" or "%f".
RegisterSet registerSet(std::string type, std::string_view text);

}  // namespace pdr::ptx
