#pragma once
/// Statements of PTX, taken apart at blanks and commas.

#include <string>
#include <string_view>
#include <vector>

namespace pdr::ptx {

struct Statement {
    int line;                           ///< line of the module's text, from 1
    std::string label;                  ///< name of the place; all else is then empty
    std::string guard;                  ///< "%p1", "!%p1", or empty
    std::string operation;              ///< "add.rn.f32"
    std::vector<std::string> operands;  ///< "%f1", "[%rd1+4]", "{%f1, %f2}"

    /// The statement in one line, without its guard.
    std::string text() const;
};

/// Returns `text` without the blanks around it.
std::string_view trimmed(std::string_view text);
/// Cuts the first word off `text` and returns it.
std::string_view takeWord(std::string_view& text);
/// Cuts at the commas that stand in no brackets.
std::vector<std::string> cutOperands(std::string_view text);
/// Returns what a vector in braces holds; any other operand alone.
std::vector<std::string> elementsOf(const std::string& operand);

}  // namespace pdr::ptx
