#pragma once
/// `pdrender-cli looks`: what there is to choose from.

#include <QStringList>

namespace pdr::app {

/// `arguments` come after the word "looks". Prints to stdout. Returns 0, 1 on an error, 2 on wrong usage.
int runLooks(const QStringList& arguments);

}  // namespace pdr::app
