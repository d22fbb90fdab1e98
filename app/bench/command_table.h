#pragma once
/// The commands of pdrender-bench with what a user is told about them.

#include <span>
#include <string>

#include "app/bench/commands.h"

namespace pdr::bench {

struct Command {
    const char* name;
    int (*run)(const Arguments&);
    const char* usage;        ///< the words after the name, where options are in brackets
    const char* explanation;  ///< what it does, in lines of their own
    const char* options;      ///< each in a line of its own
};

std::span<const Command> commandTable();

/// The usage of one command, its explanation, and what each option means.
std::string helpOf(const Command& command);
/// The usage of all.
std::string helpOfAll();

}  // namespace pdr::bench
