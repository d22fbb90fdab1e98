#pragma once
/// A key pair on P-256 and a certificate of it, signed by another or by itself. What certificates.h makes bundles of.

#include <QByteArray>
#include <QString>
#include <chrono>
#include <memory>

#include "render/base/result.h"

struct evp_pkey_st;
struct x509_st;

namespace pdr::remote {

struct CertificateOrder {
    QString name;            ///< the common name; what signs nothing has it as a DNS name, too
    bool authority = false;  ///< signs others, and is for nothing else; else shown by either side of a TLS connection
    std::chrono::system_clock::time_point from, until;
};

struct SignedCertificate {
    std::shared_ptr<evp_pkey_st> key;
    std::shared_ptr<x509_st> certificate;

    QByteArray certificatePem() const;
    QByteArray keyPem() const;  ///< PKCS 8, not encrypted
};

/// With a new key. Without an issuer it signs itself. Errors: OpenSSL's, as where no random numbers are to be had.
Result<SignedCertificate> makeCertificate(const CertificateOrder& order, const SignedCertificate* issuer = nullptr);

/// Whether the key is the certificate's, and the certificate signed by that authority. PEM.
bool belongTogether(const QByteArray& key, const QByteArray& certificate, const QByteArray& authority);

}  // namespace pdr::remote
