#pragma once
/// Who this program is on the network, and whom it talks to: TLS 1.3, with a certificate on both sides, both signed by
/// the bundle's own authority and by no other.

#include <QSslCertificate>
#include <QSslConfiguration>
#include <optional>

#include "app/remote/address.h"
#include "app/remote/role.h"
#include "render/base/result.h"

namespace pdr::remote {

struct Identity {
    Role role = Role::node;                ///< this side's; the other side's is other(role)
    std::optional<QSslConfiguration> tls;  ///< none: plain TCP, where anybody is believed
};

/// Of TLS connections that show `chain` and believe nobody but what `authorities` have signed. Asks the other side for
/// its certificate, whoever dials.
QSslConfiguration tlsConfiguration(const QList<QSslCertificate>& authorities, const QList<QSslCertificate>& chain,
                                   const QSslKey& key);

/// `folder`: that role's part of a bundle (certificates.h), or the whole bundle. Errors: files that are missing, cannot
/// be read, are another role's, do not belong together, have expired; a key that others on this machine may read
/// (the program's group may, where root has handed it out).
Result<Identity> readIdentity(const QString& folder, Role role);

/// Whom to be when dialling or listening at `address`. Plain TCP only where the address is this machine itself and
/// `folder` is empty. Errors: as above; no bundle for another machine.
Result<Identity> identityFor(const Address& address, const QString& folder, Role role);

/// Whether it is that role's. The name alone: that it is signed is seen to by TLS.
bool isOf(const QSslCertificate& certificate, Role role);

}  // namespace pdr::remote
