#pragma once
/// Options of `pdrender-cli render` for render nodes that help.

#include <QCommandLineParser>

#include "app/cli/nodes/command_nodes.h"

namespace pdr::app {

void describeNodeOptions(QCommandLineParser& parser);

/// Reads the options. Throws an Error that names the first wrong option.
NodesWanted readNodeOptions(const QCommandLineParser& parser);

}  // namespace pdr::app
