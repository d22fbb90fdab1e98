#pragma once
/// Precompiled header for tests of the desktop: adds the desktop, which takes most of the time to parse.

#include "tests/support/precompiled.h"
// Must come after TBB, which has names that Qt defines as keywords.
#include "tests/support/desktop/desktop_trial.h"
