/// Entry point of pdrender-bench, which measures the renderer alone. It has no window and no DICOM, so that it also
/// runs on a bare machine with a GPU.

#include <algorithm>
#include <cstdio>

#include "app/bench/command_table.h"
#include "app/program/program.h"
#include "render/base/version.h"

namespace pdr::bench {
namespace {

bool asksForHelp(const std::string& word) {
    return word == "--help" || word == "-h" || word == "help";
}

int usageError(const std::string& what, const std::string& help) {
    std::fprintf(stderr, "pdrender-bench: %s\n\n%s\"pdrender-bench help COMMAND\" or COMMAND --help says more.\n",
                 what.c_str(), help.c_str());
    return 2;
}

int run(const Command& command, const Arguments& arguments) {
    if (std::ranges::any_of(arguments, [](const std::string& word) { return word == "--help" || word == "-h"; })) {
        std::fputs(helpOf(command).c_str(), stdout);
        return 0;
    }
    const int code = command.run(arguments);
    if (code == kExplained)
        return 2;
    return code == 2 ? usageError("these words cannot be understood", helpOf(command)) : code;
}

int run(Arguments words) {
    if (words.empty())
        return usageError("say what to measure", helpOfAll());
    if (words[0] == "--version" || words[0] == "-v") {
        std::puts("PD-Render " PDR_VERSION);
        return 0;
    }
    if (asksForHelp(words[0]) && words.size() == 1) {
        std::fputs(helpOfAll().c_str(), stdout);
        return 0;
    }
    if (asksForHelp(words[0]))
        words = {words[1], "--help"};
    const auto commands = commandTable();
    const auto command = std::ranges::find_if(commands, [&](const Command& one) { return words[0] == one.name; });
    if (command == commands.end())
        return usageError("there is no command \"" + words[0] + "\"", helpOfAll());
    return run(*command, Arguments(words.begin() + 1, words.end()));
}

}  // namespace
}  // namespace pdr::bench

int main(int argc, char** argv) {
    return pdr::app::runProgram("pdrender-bench",
                                [&] { return pdr::bench::run(pdr::bench::Arguments(argv + 1, argv + argc)); });
}
