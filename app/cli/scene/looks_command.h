#pragma once
/// Command `pdrender-cli looks`: lists the bundled looks.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word "looks". Prints to stdout. Returns 0, 1 on an error, 2 on
/// wrong usage.
int runLooks(const QStringList& arguments);

}  // namespace pdr::app
