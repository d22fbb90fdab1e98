#pragma once
/// Command `pdrender-cli replay FOLDER|SCENE.json --pixel X,Y --sample N`: prints one sample event by event.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word `replay`. Returns the exit code.
int runReplay(const QStringList& arguments);

}  // namespace pdr::app
