#pragma once
/// Command `pdrender-cli accuracy FOLDER|SCENE.json -o DIR`: measures on this machine how much time accuracy costs.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word `accuracy`. Returns the exit code.
int runAccuracy(const QStringList& arguments);

}  // namespace pdr::app
