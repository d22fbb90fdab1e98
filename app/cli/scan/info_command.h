#pragma once
/// Command `pdrender-cli info FOLDER [--json]`: lists what the importer finds in a folder, with figures that another
/// program can check.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word "info". Prints results to stdout, progress and errors to
/// stderr; never a patient's name. Returns 0, 1 on an error, 2 on wrong usage.
int runInfo(const QStringList& arguments);

}  // namespace pdr::app
