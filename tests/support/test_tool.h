#pragma once
/// Programs of Debian that tests ask for a second opinion; `./bootstrap test` installs them.

#include <QStandardPaths>

#include "tests/support/shared_data.h"

/// Leaves the test function where the program `tool`, of the Debian package `package`, is not there: as skipped, or
/// as failed where all is required.
#define PDR_NEEDS_TOOL(tool, package)                   \
    if (QStandardPaths::findExecutable(tool).isEmpty()) \
    PDR_SKIP_FOR_WANT_OF_DATA(tool " is not here: ./bootstrap test installs the package " package)
