#pragma once
/// pdrender-cli replay FOLDER|SCENE.json --pixel X,Y --sample N: one sample, event by event.

#include <QStringList>

namespace pdr::app {

/// `arguments` are those after the word `replay`. Returns the exit code.
int runReplay(const QStringList& arguments);

}  // namespace pdr::app
