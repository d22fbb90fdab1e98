#pragma once
/// What all connections between coordinator and nodes ask of the system.

#include <QTcpSocket>
#include <chrono>

namespace pdr::remote {

/// Small messages go out at once; a connection whose other side is out of reach fails, after `unheard` where something
/// is on its way and after 5 s where it is idle, and so does one whose other side takes nothing for so long; a fast
/// sender is slowed down before it fills the memory.
void setOptions(QTcpSocket& socket, std::chrono::milliseconds unheard);

}  // namespace pdr::remote
