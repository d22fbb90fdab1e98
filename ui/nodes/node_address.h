#pragma once
/// Where a node is reached: what a hand typed, understood or told what is wrong with it.

#include <QString>

namespace pdr::ui {

struct TypedAddress {
    QString address;  ///< "gpu-07:4743", "[fe80::1]:4743"; empty where it is none
    QString problem;  ///< a sentence for the user; empty where there is none
};

/// `text`: as readNetworkAddress() (render/base/network_address.h) takes it, within blanks; its port is not 0.
TypedAddress readAddress(const QString& text);

}  // namespace pdr::ui
