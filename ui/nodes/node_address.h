#pragma once
/// Where a node is reached: what a hand typed, understood or told what is wrong with it.

#include <QString>

namespace pdr::ui {

/// Of nodes and coordinators where none is given.
inline constexpr quint16 kNodePort = 4743;

struct TypedAddress {
    QString address;  ///< "gpu-07:4743", "[fe80::1]:4743"; empty where it is none
    QString problem;  ///< a sentence for the user; empty where there is none
};

/// `text`: "host" or "host:port"; a host is a name, an IPv4 address, or an IPv6 address in brackets.
TypedAddress readAddress(const QString& text);

}  // namespace pdr::ui
