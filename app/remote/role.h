#pragma once
/// The roles of the two sides of a connection. A certificate states the role of its owner, no matter which side dials.

#include <QString>

#include "app/wire/frame_header.h"

namespace pdr::remote {

using wire::Role;

constexpr Role other(Role role) {
    return role == Role::coordinator ? Role::node : Role::coordinator;
}

/// Returns the name of a role in certificates, as a DNS name.
inline QString nameIn(Role role) {
    return role == Role::coordinator ? QStringLiteral("pdrender-coordinator") : QStringLiteral("pdrender-node");
}

/// Returns the folder name of a role's part of a bundle of certificates.
inline QString folderOf(Role role) {
    return role == Role::coordinator ? QStringLiteral("coordinator") : QStringLiteral("node");
}

}  // namespace pdr::remote
