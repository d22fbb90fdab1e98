#pragma once
/// What each instruction does to the lanes of a warp (PTX ISA, chapter "Instruction Set"). Each function returns the
/// operation of that name; null: it is not known.

#include <vector>

#include "tests/ptx/code/instruction.h"
#include "tests/ptx/text/mnemonic.h"

namespace pdr::ptx {

/// add, sub, mul, mad, fma, div, rem, min, max, neg, abs, rcp, sqrt, copysign.
Operation arithmetic(const Mnemonic& what);
/// and, or, xor, not, shl, shr, popc, clz, bfi, prmt.
Operation bitwise(const Mnemonic& what);
/// Returns the types of the sources, from the first; those that are missing are of the last one.
std::vector<Type> sourceTypes(const Mnemonic& what);
/// cvt.
Operation conversion(const Mnemonic& what);
/// setp.
Operation comparison(const Mnemonic& what);
/// selp: from[2] is the predicate.
Operation choice(Type type);
/// mov.
Operation copy(u32 bits);
/// and, or, xor, not, mov of predicates.
Operation predicateLogic(const Mnemonic& what);
/// mov.b64 of two halves, and into two.
Operation joinHalves();
Operation cutIntoHalves();

enum class Space { global, generic, local, parameter };
/// ld; `registerBits`: of the registers that it loads into.
Operation load(Space space, Type type, u32 registerBits);
/// st.
Operation store(Space space, Type type);
/// cvta of local addresses, which generic ones hold in a window: to it, or from it.
Operation toLocalWindow();
Operation fromLocalWindow();
/// atom, red: from[1] is the operand.
Operation atomic(const Mnemonic& what);
/// tex.3d: from[0] is the texture, from[1] to from[3] the place.
Operation textureFetch();
/// vote, shfl: from[4] is the mask of the lanes that take part.
Operation vote(const Mnemonic& what);
Operation shuffle(const Mnemonic& what);

}  // namespace pdr::ptx
