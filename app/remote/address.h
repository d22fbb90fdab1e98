#pragma once
/// Where a coordinator or a node listens.

#include <QString>
#include <cstdint>

#include "render/base/network_address.h"
#include "render/base/result.h"

namespace pdr::remote {

struct Address {
    QString host;  ///< a name, or an IP address without brackets; empty: all of this machine's
    quint16 port = kNodePort;

    /// Only reachable from this machine: "localhost", 127.0.0.0/8, ::1.
    bool isLoopback() const;
    /// "host:port", "[::1]:port"
    QString text() const;
    bool operator==(const Address&) const = default;
};

/// To dial: "host", "host:port", "[::1]:port", "::1". Errors: no host, no such port.
Result<Address> parseAddress(const QString& text);
/// To listen at: as above, or a port alone, at all addresses of this machine. Port 0: one that is free.
Result<Address> parseListening(const QString& text);

}  // namespace pdr::remote
