#pragma once
/// `pdrender-cli plan`: lists, exports and renders what a plan holds.

#include <QStringList>

namespace pdr::app {

/// Runs the command with the arguments after the word `plan`. Returns the exit code.
int runPlan(const QStringList& arguments);

}  // namespace pdr::app
