#include "tests/ptx/code/operand_table.h"

#include <algorithm>

#include "tests/ptx/base/findings.h"

namespace pdr::ptx {

namespace {

/// In a register file: 16 bits lie in 32.
u32 storedBytes(Type type) {
    return bitsOf(type) == 64 ? 8 : 4;
}

[[noreturn]] void wrongSize(const std::string& operand, u32 bytes) {
    throw NotKnown(operand + " as " + std::to_string(bytes) + " bytes");
}

/// "-1", "0x10", "0f3F800000" and "0d3FF0000000000000", the last two by their bits.
u64 numberIn(const std::string& operand, u32 bytes) {
    if (operand.starts_with("0f") || operand.starts_with("0d")) {
        if ((operand[1] == 'd') != (bytes == 8))
            wrongSize(operand, bytes);
        return std::stoull(operand.substr(2), nullptr, 16);
    }
    return operand.front() == '-' ? u64(std::stoll(operand, nullptr, 0)) : std::stoull(operand, nullptr, 0);
}

u64 cut(u64 number, Type type) {
    return bitsOf(type) == 64 ? number : bitsOf(type) == 16 ? number & 0xFFFF : number & 0xFFFFFFFF;
}

}  // namespace

OperandTable::OperandTable(Program& program) : program_(program) {
    for (const RegisterSet& set : program.text.registers) {
        if (set.count == 0)
            declare(set.prefix, typeNamed(set.type));
        for (u32 n = 0; n < set.count; ++n)
            declare(set.prefix + std::to_string(n), typeNamed(set.type));
    }
}

void OperandTable::declare(const std::string& name, Type type) {
    const u32 slot = type == Type::pred ? program_.predicates++ : room(storedBytes(type));
    registers_[name] = {slot, bitsOf(type)};
}

u32 OperandTable::room(u32 bytes) {
    const u32 slot = program_.fileBytes;
    program_.fileBytes += bytes * kLanes;
    return slot;
}

const OperandTable::Register& OperandTable::known(const std::string& name) const {
    const auto found = registers_.find(name);
    if (found == registers_.end())
        throw NotKnown("register " + name);
    return found->second;
}

u32 OperandTable::destination(const std::string& operand, u32 bits) const {
    if (operand == "_")
        return kNone;
    const Register& to = known(operand);
    if (to.bits == 1 || to.bits < bits)
        throw NotKnown(operand + " is too small");
    return to.slot;
}

bool OperandTable::isWider(const std::string& operand, Type type) const {
    const auto found = registers_.find(operand);
    return found != registers_.end() && found->second.bits == 64 && storedBytes(type) == 4 && !isFloat(type);
}

u32 OperandTable::source(const std::string& operand, Type type) {
    const u32 bytes = storedBytes(type);
    if (operand.front() != '%')
        return constant(cut(numberIn(operand, bytes), type), bytes);
    const auto found = registers_.find(operand);
    if (found == registers_.end())
        return special(operand);
    if (found->second.bits == 1 || (found->second.bits == 64) != (bytes == 8))
        wrongSize(operand, bytes);
    return found->second.slot;
}

u32 OperandTable::predicate(const std::string& operand) {
    if (operand.front() != '%') {
        program_.constantPredicates.emplace_back(program_.predicates, operand != "0");
        return program_.predicates++;
    }
    const Register& one = known(operand);
    if (one.bits != 1)
        throw NotKnown(operand + " as a predicate");
    return one.slot;
}

u32 OperandTable::constant(u64 bits, u32 bytes) {
    const auto [known, isNew] = constants_.try_emplace(std::to_string(bytes) + ":" + std::to_string(bits), 0);
    if (isNew) {
        known->second = room(bytes);
        program_.constants.push_back({known->second, bytes, bits});
    }
    return known->second;
}

u32 OperandTable::special(const std::string& name) {
    for (const SpecialRegister& one : program_.specials)
        if (one.name == name)
            return one.slot;
    program_.specials.push_back({name, room(4)});
    return program_.specials.back().slot;
}

const Parameter* OperandTable::parameterNamed(const std::string& name) const {
    const auto& all = program_.text.parameters;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& one) { return one.name == name; });
    return found != all.end() ? &*found : nullptr;
}

u32 OperandTable::addressOf(const std::string& operand) {
    if (const auto local = program_.text.locals.find(operand); local != program_.text.locals.end())
        return constant(local->second, 8);
    const Parameter* parameter = parameterNamed(operand);
    if (parameter == nullptr)
        return kNone;
    program_.constants.push_back({room(8), 8, parameter->offset, true});
    return program_.constants.back().slot;
}

void OperandTable::address(const std::string& operand, Instruction& instruction) {
    const std::string inside = operand.substr(1, operand.size() - 2);
    const std::size_t plus = inside.find('+');
    const std::string base = inside.substr(0, plus);
    instruction.offset = plus == inside.npos ? 0 : std::stoll(inside.substr(plus + 1));
    if (base.front() == '%') {
        instruction.from[0] = source(base, Type::b64);
        return;
    }
    const Parameter* parameter = parameterNamed(base);
    const auto local = program_.text.locals.find(base);
    if (parameter == nullptr && local == program_.text.locals.end())
        throw NotKnown("address " + operand);
    instruction.offset += parameter != nullptr ? parameter->offset : local->second;
}

}  // namespace pdr::ptx
