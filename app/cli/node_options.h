#pragma once
/// The options of `pdrender-cli render` for render nodes that help.

#include <QCommandLineParser>

#include "app/cli/node_crew.h"

namespace pdr::app {

void describeNodeOptions(QCommandLineParser& parser);

/// Throws an Error that names the first option that is wrong.
NodesWanted readNodeOptions(const QCommandLineParser& parser);

}  // namespace pdr::app
