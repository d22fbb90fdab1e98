#include "tests/ptx/code/decode.h"

#include "tests/ptx/base/findings.h"
#include "tests/ptx/code/block_order.h"
#include "tests/ptx/code/operand_decoder.h"

namespace pdr::ptx {

namespace {

bool endsBlock(const Mnemonic& what) {
    return what.base == "bra" || what.base == "ret" || what.base == "exit";
}

/// Cuts a kernel's statements into blocks.
class Decoder {
  public:
    Decoder(const KernelText& text, bool byAddress)
        : program_(std::make_unique<Program>(Program{.text = text})), operands_(*program_), byAddress_(byAddress) {}

    std::unique_ptr<Program> run() {
        newBlock();
        for (const Statement& statement : program_->text.statements)
            try {
                add(statement);
            } catch (const NotKnown& error) {
                throw NotKnown("PTX line " + std::to_string(statement.line) + ", " + statement.text() + ": " +
                               error.what());
            }
        for (std::size_t b = 0; b < program_->blocks.size(); ++b)
            if (!targets_[b].empty())
                program_->blocks[b].target = labels_.at(targets_[b]);
        order();
        return std::move(program_);
    }

  private:
    Block& block() { return program_->blocks.back(); }
    u32 here() const { return u32(program_->instructions.size()); }

    void newBlock() {
        program_->blocks.push_back({here(), here()});
        targets_.emplace_back();
    }
    /// What follows can be entered from elsewhere, too.
    void beginBlock() {
        if (block().first != here() || block().end != Block::End::next)
            newBlock();
    }

    void count(const Statement& s) {
        if (block().statements++ == 0)
            block().firstLine = s.line;
        block().lastLine = s.line;
    }

    void add(const Statement& s) {
        if (!s.label.empty()) {
            beginBlock();
            labels_[s.label] = u32(program_->blocks.size() - 1);
            return;
        }
        const Mnemonic what(s.operation);
        if (endsBlock(what)) {
            count(s);
            return end(s, what);
        }
        const bool meets = what.has("sync");
        if (meets && !s.guard.empty())
            throw NotKnown("a guard of lanes that meet");
        if (meets)
            beginBlock();
        count(s);
        Instruction instruction = operands_.decode(s, what);
        if (instruction.run == nullptr)
            throw NotKnown("this operation");
        if (meets)
            block().memberMask = instruction.from[4];
        program_->instructions.push_back(std::move(instruction));
        block().last = here();
        if (meets)
            newBlock();
    }

    void end(const Statement& s, const Mnemonic& what) {
        const bool exits = what.base != "bra";
        if (!exits)
            targets_.back() = s.operands.at(0);
        block().exits = exits;
        if (s.guard.empty()) {
            block().end = exits ? Block::End::exit : Block::End::jump;
        } else {
            block().end = Block::End::branch;
            block().predicateNot = s.guard.front() == '!';
            block().predicate = operands_.table().predicate(s.guard.substr(block().predicateNot ? 1 : 0));
        }
        newBlock();
    }

    void order() {
        const std::vector<u32> order = meetingOrder(program_->blocks);
        for (u32 n = 0; n < order.size(); ++n)
            program_->blocks[order[n]].order = byAddress_ ? order[n] : n;
    }

    std::unique_ptr<Program> program_;
    OperandDecoder operands_;
    bool byAddress_;
    std::unordered_map<std::string, u32> labels_;
    std::vector<std::string> targets_;  ///< label that each block jumps to, or empty
};

}  // namespace

std::unique_ptr<Program> decode(const KernelText& text, bool byAddress) {
    try {
        return Decoder(text, byAddress).run();
    } catch (const NotKnown& error) {
        throw NotKnown(text.name + ": " + error.what());
    }
}

}  // namespace pdr::ptx
