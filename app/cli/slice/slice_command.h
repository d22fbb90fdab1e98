#pragma once
/// Command `pdrender-cli slice`: writes a slice of a scan, as an image or as HU.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word `slice`. Returns the exit code: 0, 1 for an error, 2 for
/// wrong usage.
int runSlice(const QStringList& arguments);

}  // namespace pdr::app
