#pragma once
/// pdrender-cli accuracy FOLDER|SCENE.json -o DIR: what accuracy costs in time, measured on this machine.

#include <QStringList>

namespace pdr::app {

/// `arguments` are those after the word `accuracy`. Returns the exit code.
int runAccuracy(const QStringList& arguments);

}  // namespace pdr::app
