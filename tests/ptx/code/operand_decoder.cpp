#include "tests/ptx/code/operand_decoder.h"

#include <algorithm>
#include <array>

#include "tests/ptx/base/findings.h"
#include "tests/ptx/operations/operations.h"

namespace pdr::ptx {

namespace {

Space spaceOf(const Mnemonic& what) {
    if (!what.hasOnly({"global", "local", "param", "volatile", "v2", "v4", "nc"}))
        throw NotKnown("this way to access memory");
    return what.has("global")  ? Space::global
           : what.has("local") ? Space::local
           : what.has("param") ? Space::parameter
                               : Space::generic;
}

}  // namespace

Instruction OperandDecoder::decode(const Statement& s, const Mnemonic& what) {
    Instruction i;
    line_ = i.line = u32(s.line);
    i.text = s.operation;
    if (!s.guard.empty()) {
        i.guardNot = s.guard.front() == '!';
        i.guard = table_.predicate(s.guard.substr(i.guardNot ? 1 : 0));
    }
    const auto isOneOf = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, what.base) != names.end();
    };
    if (isOneOf({"mov", "cvta"}))
        move(s, what, i);
    else if (isOneOf({"ld", "st"}))
        access(s, what, i);
    else if (isOneOf({"atom", "red"}))
        changeAtomically(s, what, i);
    else if (isOneOf({"tex"}))
        fetch(s, i);
    else if (isOneOf({"vote", "shfl"}))
        tellLanes(s, what, i);
    else
        compute(s, what, i);
    return i;
}

/// A register may be wider than what is read of it: its lower half is taken first.
u32 OperandDecoder::source(const std::string& operand, Type type) {
    if (!table_.isWider(operand, type))
        return table_.source(operand, type);
    Instruction lower;
    lower.run = conversion(Mnemonic("cvt.u32.u64"));
    lower.to[0] = table_.room(4);
    lower.from[0] = table_.source(operand, Type::b64);
    lower.line = line_;
    lower.text = "(lower half)";
    program_.instructions.push_back(lower);
    program_.blocks.back().last = u32(program_.instructions.size());
    return lower.to[0];
}

void OperandDecoder::access(const Statement& s, const Mnemonic& what, Instruction& i) {
    const bool loads = what.base == "ld";
    const Space space = spaceOf(what);
    const Type type = what.type();
    const std::vector<std::string> values = elementsOf(s.operands.at(loads ? 0 : 1));
    i.isVolatile = what.has("volatile");
    i.count = u8(values.size());
    i.bytes = u8(bitsOf(type) / 8);
    table_.address(s.operands.at(loads ? 1 : 0), i);
    u32 registerBits = 32;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (!loads) {
            i.from.at(1 + n) = source(values[n], type);
            continue;
        }
        i.to.at(n) = table_.destination(values[n], bitsOf(type));
        if (i.to[n] != kNone)
            registerBits = table_.bitsOfRegister(values[n]);
    }
    i.run = loads ? load(space, type, registerBits) : store(space, type);
}

/// mov and cvta: of registers, predicates, halves and addresses.
void OperandDecoder::move(const Statement& s, const Mnemonic& what, Instruction& i) {
    const std::string &to = s.operands.at(0), &from = s.operands.at(1);
    const Type type = what.type();
    if (what.base == "cvta") {
        i.from[0] = source(from, Type::b64);
        i.to[0] = table_.destination(to, 64);
        i.run = !what.has("local") ? copy(64) : what.has("to") ? fromLocalWindow() : toLocalWindow();
    } else if (type == Type::pred) {
        i.to[0] = table_.predicate(to);
        i.from[0] = table_.predicate(from);
        i.run = predicateLogic(what);
    } else if (to.front() == '{' && bitsOf(type) == 64) {
        const std::vector<std::string> halves = elementsOf(to);
        i.from[0] = source(from, type);
        i.to[0] = table_.destination(halves.at(0), 32);
        i.to[1] = table_.destination(halves.at(1), 32);
        i.run = cutIntoHalves();
    } else if (from.front() == '{' && bitsOf(type) == 64) {
        const std::vector<std::string> halves = elementsOf(from);
        i.to[0] = table_.destination(to, 64);
        i.from[0] = source(halves.at(0), Type::b32);
        i.from[1] = source(halves.at(1), Type::b32);
        i.run = joinHalves();
    } else {
        i.to[0] = table_.destination(to, bitsOf(type));
        i.from[0] = table_.addressOf(from);
        if (i.from[0] == kNone)
            i.from[0] = source(from, type);
        i.run = copy(bitsOf(type));
    }
}

void OperandDecoder::changeAtomically(const Statement& s, const Mnemonic& what, Instruction& i) {
    const bool gives = what.base == "atom";
    const Type type = what.type();
    i.bytes = u8(bitsOf(type) / 8);
    if (gives)
        i.to[0] = table_.destination(s.operands.at(0), bitsOf(type));
    table_.address(s.operands.at(gives ? 1 : 0), i);
    i.from[1] = source(s.operands.at(gives ? 2 : 1), type);
    i.run = atomic(what);
}

void OperandDecoder::fetch(const Statement& s, Instruction& i) {
    if (s.operation != "tex.3d.v4.f32.f32")
        return;
    const std::vector<std::string> found = elementsOf(s.operands.at(0));
    const std::string& inBrackets = s.operands.at(1);
    const std::vector<std::string> from = cutOperands(inBrackets.substr(1, inBrackets.size() - 2));
    const std::vector<std::string> place = elementsOf(from.at(1));
    i.from[0] = source(from[0], Type::b64);
    for (std::size_t n = 0; n < 3; ++n)
        i.from[1 + n] = source(place.at(n), Type::f32);
    for (std::size_t n = 0; n < 4; ++n)
        i.to[n] = table_.destination(found.at(n), 32);
    i.run = textureFetch();
}

void OperandDecoder::tellLanes(const Statement& s, const Mnemonic& what, Instruction& i) {
    const std::string& to = s.operands.at(0);
    i.from[4] = source(s.operands.back(), Type::b32);
    if (what.base == "vote") {
        i.to[0] = what.has("ballot") ? table_.destination(to, 32) : table_.predicate(to);
        i.from[0] = table_.predicate(s.operands.at(1));
        i.run = vote(what);
        return;
    }
    const std::size_t bar = to.find('|');  // "%r1|%p1": the predicate says whether the lane taken from is there
    i.to[0] = table_.destination(to.substr(0, bar), 32);
    if (bar != to.npos)
        i.to[1] = table_.predicate(to.substr(bar + 1));
    for (std::size_t n = 0; n < 3; ++n)
        i.from[n] = source(s.operands.at(n + 1), Type::b32);
    i.run = shuffle(what);
}

/// Everything that only registers, predicates and constants take part in.
void OperandDecoder::compute(const Statement& s, const Mnemonic& what, Instruction& i) {
    const Type type = what.type();
    const std::string& to = s.operands.at(0);
    const std::size_t sources = s.operands.size() - 1;
    if (sources > i.from.size())
        return;
    if (what.base == "setp" && sources == 2) {
        i.to[0] = table_.predicate(to);
        i.from[0] = source(s.operands[1], type);
        i.from[1] = source(s.operands[2], type);
        i.run = comparison(what);
    } else if (what.base == "selp" && sources == 3) {
        i.to[0] = table_.destination(to, bitsOf(type));
        i.from[0] = source(s.operands[1], type);
        i.from[1] = source(s.operands[2], type);
        i.from[2] = table_.predicate(s.operands[3]);
        i.run = choice(type);
    } else if (type == Type::pred) {
        i.to[0] = table_.predicate(to);
        for (std::size_t n = 0; n < sources; ++n)
            i.from[n] = table_.predicate(s.operands[n + 1]);
        i.run = predicateLogic(what);
    } else {
        i.run = what.base == "cvt" ? conversion(what) : arithmetic(what);
        if (i.run == nullptr)
            i.run = bitwise(what);
        i.to[0] = table_.destination(to, what.types.empty() ? 0 : std::min(bitsOf(what.types[0]), 32u));
        const std::vector<Type> types = sourceTypes(what);
        for (std::size_t n = 0; n < sources; ++n)
            i.from[n] = source(s.operands[n + 1], types[std::min(n, types.size() - 1)]);
    }
}

}  // namespace pdr::ptx
