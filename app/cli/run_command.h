#pragma once
/// How every command that renders begins: with its options, or with what is wrong about them, or with its help.

#include <cstdio>
#include <string>

#include "app/cli/failed.h"
#include "render/base/result.h"

namespace pdr::app {

/// `run` takes the options and returns the exit code; 2 where the options are wrong.
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
