#pragma once
/// pdrender-cli effects FOLDER|SCENE.json: what the picture is made of, and what each part costs.

#include <QStringList>

namespace pdr::app {

/// `arguments` are those after the word `effects`. Returns the exit code.
int runEffects(const QStringList& arguments);

}  // namespace pdr::app
