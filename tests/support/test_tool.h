#pragma once
/// Debian programs whose results tests compare with; `./bootstrap test` installs them.

#include <QStandardPaths>

#include "tests/support/dicom/shared_data.h"

/// Leaves the test function if the program `tool`, of the Debian package `package`, is missing: as skipped or, if
/// PDR_REQUIRE_DATA is set, as failed.
#define PDR_NEEDS_TOOL(tool, package)                   \
    if (QStandardPaths::findExecutable(tool).isEmpty()) \
    PDR_SKIP_FOR_WANT_OF_DATA(tool " is not here: ./bootstrap test installs the package " package)
