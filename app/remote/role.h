#pragma once
/// The two sides of a connection. A certificate says which of them its owner is, whoever dials whom.

#include <QString>

#include "app/wire/frame_header.h"

namespace pdr::remote {

using wire::Role;

constexpr Role other(Role role) {
    return role == Role::coordinator ? Role::node : Role::coordinator;
}

/// In certificates, as a DNS name.
inline QString nameIn(Role role) {
    return role == Role::coordinator ? QStringLiteral("pdrender-coordinator") : QStringLiteral("pdrender-node");
}

/// Of its part of a bundle of certificates.
inline QString folderOf(Role role) {
    return role == Role::coordinator ? QStringLiteral("coordinator") : QStringLiteral("node");
}

}  // namespace pdr::remote
