#pragma once
/// `pdrender-cli merge`: makes one image, or one film, of the films of its shares.

#include <QStringList>

namespace pdr::app {

/// Runs the command; `arguments` are those after its word. Returns the exit code.
int runMerge(const QStringList& arguments);

}  // namespace pdr::app
