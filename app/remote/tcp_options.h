#pragma once
/// What all connections between coordinator and nodes ask of the system.

#include <QTcpSocket>

namespace pdr::remote {

/// Small messages go out at once; a connection whose other side is out of reach fails after about 5 s, whether it is
/// idle or not, and so does one whose other side takes nothing for 5 s; a fast sender is slowed down before it fills
/// the memory.
void setOptions(QTcpSocket& socket);

}  // namespace pdr::remote
