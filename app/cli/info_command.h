#pragma once
/// `pdrender-cli info FOLDER [--json]`: what the importer finds in a folder, in figures that another program can check.

#include <QStringList>

namespace pdr::app {

/// `arguments` come after the word "info". Prints to stdout, progress and errors to stderr; never a patient's name.
/// Returns 0, 1 on an error, 2 on wrong usage.
int runInfo(const QStringList& arguments);

}  // namespace pdr::app
