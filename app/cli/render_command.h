#pragma once
/// `pdrender-cli render`: a folder or a scene file becomes pictures.

#include <QStringList>

namespace pdr::app {

/// `arguments` are those after the word `render`. Returns the exit code: 0, 1 for an error, 2 for wrong usage.
int runRender(const QStringList& arguments);

}  // namespace pdr::app
