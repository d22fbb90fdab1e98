#pragma once
/// What tests of the desktop include beside that, which takes most of the time to parse.

#include "tests/support/precompiled.h"
// In this order: TBB has names of its own that Qt takes for keywords.
#include "tests/support/desktop_trial.h"
