#pragma once
/// Makes an instruction of a statement: its operation, and where the numbers of its operands lie.

#include "tests/ptx/code/operand_table.h"
#include "tests/ptx/code/program.h"
#include "tests/ptx/text/mnemonic.h"

namespace pdr::ptx {

class OperandDecoder {
  public:
    explicit OperandDecoder(Program& program) : program_(program), table_(program) {}

    OperandTable& table() { return table_; }

    /// `what`: the statement's operation, of those that end no block. An instruction whose `run` is null is not known.
    /// Adds instructions to the program where operands need them first. Throws NotKnown at an operand.
    Instruction decode(const Statement& s, const Mnemonic& what);

  private:
    void access(const Statement& s, const Mnemonic& what, Instruction& i);
    void move(const Statement& s, const Mnemonic& what, Instruction& i);
    void changeAtomically(const Statement& s, const Mnemonic& what, Instruction& i);
    void fetch(const Statement& s, Instruction& i);
    void tellLanes(const Statement& s, const Mnemonic& what, Instruction& i);
    void compute(const Statement& s, const Mnemonic& what, Instruction& i);
    u32 source(const std::string& operand, Type type);

    Program& program_;
    OperandTable table_;
    u32 line_ = 0;
};

}  // namespace pdr::ptx
