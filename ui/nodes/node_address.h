#pragma once
/// The parser for a typed node address, which explains what is wrong with an invalid one.

#include <QString>

namespace pdr::ui {

struct TypedAddress {
    QString address;  ///< "gpu-07:4743", "[fe80::1]:4743"; empty if invalid
    QString problem;  ///< what is wrong, a sentence for the user; empty if valid
};

/// Reads an address as readNetworkAddress() (render/base/network_address.h) does, ignoring blanks around `text`. The
/// port must not be 0.
TypedAddress readAddress(const QString& text);

}  // namespace pdr::ui
