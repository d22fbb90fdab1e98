#pragma once
/// Mutual TLS 1.3: both sides have a certificate that is signed by the bundle's own authority, and no other authority
/// is trusted.

#include <QSslCertificate>
#include <QSslConfiguration>
#include <QSslError>
#include <optional>

#include "app/remote/address.h"
#include "app/remote/role.h"
#include "render/base/result.h"

namespace pdr::remote {

struct Identity {
    Role role = Role::node;                ///< role of this side; the peer has other(role)
    std::optional<QSslConfiguration> tls;  ///< none: plain TCP, without authentication
    QStringList revoked;                   ///< names of certificates that are no longer believed
};

/// Makes a configuration that presents `chain`, trusts only `authorities` and demands a certificate of the peer,
/// whichever side dials.
QSslConfiguration tlsConfiguration(const QList<QSslCertificate>& authorities, const QList<QSslCertificate>& chain,
                                   const QSslKey& key);

/// Reads and checks the identity of a role. `folder`: that role's part of a bundle (certificates.h), or the whole
/// bundle. Errors: files that are missing, cannot be read, belong to another role, do not belong together, have
/// expired; a key that others on this machine may read (the program's group may, if root owns the file); a list of
/// revoked certificates that cannot be read. The list is the file revoked.txt beside the certificate: a name a line.
Result<Identity> readIdentity(const QString& folder, Role role);

/// Returns the identity for dialling or listening at `address`. Plain TCP only for loopback addresses, if `folder` is
/// empty. Errors: those of readIdentity(); another machine's address without a bundle.
Result<Identity> identityFor(const Address& address, const QString& folder, Role role);

/// Whether the certificate names that role. TLS verifies the signature.
bool isOf(const QSslCertificate& certificate, Role role);

/// Returns the name of the one node whose certificate it is, "pdrender-node-3"; empty if nodes share it.
QString ownName(const QSslCertificate& certificate);

/// Returns why the peer of `self` with that certificate is not the one expected, for a peer whose signature TLS has
/// verified; empty if it is.
Text whyNot(const QSslCertificate& peer, const Identity& self);

/// Returns why TLS does not believe the certificate of the peer of `self`: by this machine's clock, a certificate of
/// either side has expired; else the first of `errors`. Programs may run longer than their certificates are valid.
Text whyUnbelieved(const QList<QSslError>& errors, const QSslCertificate& peer, const Identity& self);

}  // namespace pdr::remote
