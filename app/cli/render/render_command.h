#pragma once
/// Command `pdrender-cli render`: renders a folder or a scene file to images.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word `render`. Returns the exit code: 0, 1 for an error, 2 for
/// wrong usage.
int runRender(const QStringList& arguments);

}  // namespace pdr::app
