#pragma once
/// Socket options of all connections between coordinator and nodes.

#include <QTcpSocket>
#include <chrono>

namespace pdr::remote {

/// Sets the options of a socket: no delay (Nagle) for small messages; a user timeout of `unheard` for unacknowledged
/// data and a keep-alive of 5 s for an idle connection, so that an unreachable peer is noticed; a bounded read buffer,
/// so that a fast sender is throttled.
void setOptions(QTcpSocket& socket, std::chrono::milliseconds unheard);

}  // namespace pdr::remote
