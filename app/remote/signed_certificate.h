#pragma once
/// A P-256 key pair and its certificate, signed with another certificate's key or with its own. Bundles consist of
/// these (certificates.h).

#include <QByteArray>
#include <QString>
#include <chrono>
#include <memory>

#include "render/base/result.h"

struct evp_pkey_st;
struct x509_st;

namespace pdr::remote {

struct CertificateOrder {
    QString name;            ///< common name
    QString dnsName;         ///< the role of its owner; empty for an authority
    bool authority = false;  ///< true: may only sign other certificates; false: for either side of a TLS connection
    std::chrono::system_clock::time_point from, until;
};

struct SignedCertificate {
    std::shared_ptr<evp_pkey_st> key;
    std::shared_ptr<x509_st> certificate;

    QByteArray certificatePem() const;
    QByteArray keyPem() const;  ///< PKCS 8, not encrypted
};

/// Makes a certificate with a new key. Without an issuer it signs itself. Errors: those of OpenSSL, for example if
/// there are no random numbers.
Result<SignedCertificate> makeCertificate(const CertificateOrder& order, const SignedCertificate* issuer = nullptr);

/// Whether the key belongs to the certificate and the authority has signed the certificate. All three are PEM.
bool belongTogether(const QByteArray& key, const QByteArray& certificate, const QByteArray& authority);

}  // namespace pdr::remote
