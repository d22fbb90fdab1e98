#pragma once
/// Common start of the commands that render: reads the options, or prints what is wrong with them, or the help.

#include <cstdio>
#include <string>

#include "app/cli/failed.h"
#include "render/base/result.h"

namespace pdr::app {

/// Calls run(options) and returns its exit code; returns 2 if the options are wrong, 0 if they ask for help.
template <class Options, class Run>
int runCommand(const char* name, const Result<Options>& options, std::string (*help)(), Run&& run) {
    if (!options) {
        failed(options.error());
        std::fprintf(stderr, "\"pdrender-cli %s --help\" lists all options.\n", name);
        return 2;
    }
    if (options->help) {
        std::fputs(help().c_str(), stdout);
        return 0;
    }
    return run(*options);
}

}  // namespace pdr::app
