#pragma once
/// Operands by name: registers, constants, special registers, variables, each given its slot.

#include <string>
#include <unordered_map>

#include "tests/ptx/code/program.h"
#include "tests/ptx/text/mnemonic.h"

namespace pdr::ptx {

/// All members throw NotKnown where the operand is none, or none of that type.
class OperandTable {
  public:
    /// Declares the registers of program.text. The program must outlive the table.
    explicit OperandTable(Program& program);

    /// Returns a new slot for 32 numbers.
    u32 room(u32 bytes);
    /// Returns the slot of a register with at least `bits`; kNone for "_", which takes no result.
    u32 destination(const std::string& operand, u32 bits) const;
    /// Returns the slot of a register, a special register or a constant.
    u32 source(const std::string& operand, Type type);
    u32 predicate(const std::string& operand);
    /// Returns the slot of a number that is the same in all lanes.
    u32 constant(u64 bits, u32 bytes);
    /// Returns the slot of a variable's address, kNone if `operand` names none.
    u32 addressOf(const std::string& operand);
    /// Sets the base and the offset of "[%rd1+4]", "[name+4]", "[%rd1]".
    void address(const std::string& operand, Instruction& instruction);

    /// Returns whether `operand` is a register of 64 bits, of which `type` is but the lower half.
    bool isWider(const std::string& operand, Type type) const;
    u32 bitsOfRegister(const std::string& name) const { return known(name).bits; }

  private:
    struct Register {
        u32 slot;  ///< or the number of a predicate
        u32 bits;  ///< 1: a predicate
    };
    void declare(const std::string& name, Type type);
    const Register& known(const std::string& name) const;
    u32 special(const std::string& name);
    const Parameter* parameterNamed(const std::string& name) const;

    Program& program_;
    std::unordered_map<std::string, Register> registers_;
    std::unordered_map<std::string, u32> constants_;
};

}  // namespace pdr::ptx
