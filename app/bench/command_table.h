#pragma once
/// Commands of pdrender-bench with their help texts.

#include <span>
#include <string>

#include "app/bench/commands.h"

namespace pdr::bench {

struct Command {
    const char* name;
    int (*run)(const Arguments&);
    const char* usage;        ///< words after the name; optional ones in brackets
    const char* explanation;  ///< what the command does, in complete lines
    const char* options;      ///< one line for each option
};

std::span<const Command> commandTable();

/// Returns the usage of one command, its explanation, and the meaning of each option.
std::string helpOf(const Command& command);
/// Returns the usage of all commands.
std::string helpOfAll();

}  // namespace pdr::bench
