#pragma once
/// Network address at which a coordinator or a node listens.

#include <QString>
#include <cstdint>

#include "render/base/network_address.h"
#include "render/base/result.h"

namespace pdr::remote {

struct Address {
    QString host;  ///< a name, or an IP address without brackets; empty: all addresses of this machine
    quint16 port = kNodePort;

    /// Whether the address is only reachable from this machine: "localhost", 127.0.0.0/8, ::1.
    bool isLoopback() const;
    /// Returns "host:port" or "[::1]:port"; "*:port" for all addresses of this machine.
    QString text() const;
    bool operator==(const Address&) const = default;
};

/// Parses an address to dial: "host", "host:port", "[::1]:port", "::1". Errors: no host, no such port.
Result<Address> parseAddress(const QString& text);
/// Parses an address to listen at: a form that parseAddress() takes, or a port alone, for all addresses of this
/// machine. Port 0: any free port.
Result<Address> parseListening(const QString& text);

}  // namespace pdr::remote
