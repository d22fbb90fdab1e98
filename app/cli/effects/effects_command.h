#pragma once
/// Command `pdrender-cli effects FOLDER|SCENE.json`: lists the effects in an image and what each of them costs.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word `effects`. Returns the exit code.
int runEffects(const QStringList& arguments);

}  // namespace pdr::app
