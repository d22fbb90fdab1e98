#include "app/remote/signed_certificate.h"

#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

namespace pdr::remote {
namespace {

constexpr long kVersion3 = 2;

Error failure() {
    const char* reason = ERR_reason_error_string(ERR_get_error());
    return {phrase("a certificate cannot be made: %1", reason ? Text(std::string(reason)) : phrase("no reason given")),
            "", ""};
}

QByteArray textOf(BIO* bio) {
    char* text = nullptr;
    const long length = BIO_get_mem_data(bio, &text);
    return {text, length};
}

bool setSerial(X509* certificate) {
    const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(BN_new(), BN_free);
    return number && BN_rand(number.get(), 127, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) &&
           BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate));
}

bool setName(X509* certificate, const QString& name) {
    const QByteArray text = name.toUtf8();
    return X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate), "CN", MBSTRING_UTF8,
                                      reinterpret_cast<const unsigned char*>(text.constData()), int(text.size()), -1,
                                      0);
}

bool setTimes(X509* certificate, const CertificateOrder& order) {
    const time_t from = std::chrono::system_clock::to_time_t(order.from);
    const time_t until = std::chrono::system_clock::to_time_t(order.until);
    return ASN1_TIME_set(X509_getm_notBefore(certificate), from) &&
           ASN1_TIME_set(X509_getm_notAfter(certificate), until);
}

bool extend(X509* certificate, X509* issuer, int nid, const QByteArray& value) {
    X509V3_CTX context;
    X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
    const std::unique_ptr<X509_EXTENSION, decltype(&X509_EXTENSION_free)> extension(
        X509V3_EXT_conf_nid(nullptr, &context, nid, value.constData()), X509_EXTENSION_free);
    return extension && X509_add_ext(certificate, extension.get(), -1);
}

/// Adds the extensions of RFC 5280, section 4.2.
bool setExtensions(X509* certificate, X509* issuer, const CertificateOrder& order) {
    const bool identified = extend(certificate, issuer, NID_subject_key_identifier, "hash") &&
                            extend(certificate, issuer, NID_authority_key_identifier, "keyid");
    if (order.authority)
        return identified && extend(certificate, issuer, NID_basic_constraints, "critical,CA:TRUE,pathlen:0") &&
               extend(certificate, issuer, NID_key_usage, "critical,keyCertSign,cRLSign");
    return identified && extend(certificate, issuer, NID_basic_constraints, "critical,CA:FALSE") &&
           extend(certificate, issuer, NID_key_usage, "critical,digitalSignature") &&
           extend(certificate, issuer, NID_ext_key_usage, "serverAuth,clientAuth") &&
           extend(certificate, issuer, NID_subject_alt_name, "DNS:" + order.dnsName.toUtf8());
}

std::shared_ptr<BIO> reader(const QByteArray& text) {
    return {BIO_new_mem_buf(text.constData(), int(text.size())), BIO_free};
}

std::shared_ptr<X509> readCertificate(const QByteArray& pem) {
    return {PEM_read_bio_X509(reader(pem).get(), nullptr, nullptr, nullptr), X509_free};
}

}  // namespace

QByteArray SignedCertificate::certificatePem() const {
    const std::unique_ptr<BIO, decltype(&BIO_free)> bio(BIO_new(BIO_s_mem()), BIO_free);
    return bio && PEM_write_bio_X509(bio.get(), certificate.get()) ? textOf(bio.get()) : QByteArray();
}

QByteArray SignedCertificate::keyPem() const {
    const std::unique_ptr<BIO, decltype(&BIO_free)> bio(BIO_new(BIO_s_secmem()), BIO_free);
    const bool written =
        bio && PEM_write_bio_PKCS8PrivateKey(bio.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
    return written ? textOf(bio.get()) : QByteArray();
}

Result<SignedCertificate> makeCertificate(const CertificateOrder& order, const SignedCertificate* issuer) {
    ERR_clear_error();
    const SignedCertificate made{{EVP_EC_gen("P-256"), EVP_PKEY_free}, {X509_new(), X509_free}};
    X509* certificate = made.certificate.get();
    if (!made.key || !certificate)
        return failure();
    if (!X509_set_version(certificate, kVersion3) || !setSerial(certificate) || !setName(certificate, order.name) ||
        !setTimes(certificate, order) || !X509_set_pubkey(certificate, made.key.get()))
        return failure();
    X509* signer = issuer ? issuer->certificate.get() : certificate;
    if (!X509_set_issuer_name(certificate, X509_get_subject_name(signer)) ||
        !setExtensions(certificate, signer, order) ||
        !X509_sign(certificate, issuer ? issuer->key.get() : made.key.get(), EVP_sha256()))
        return failure();
    return made;
}

bool belongTogether(const QByteArray& key, const QByteArray& certificate, const QByteArray& authority) {
    char noPassword[] = "";  // else OpenSSL asks for one at the terminal
    const std::shared_ptr<EVP_PKEY> secret(PEM_read_bio_PrivateKey(reader(key).get(), nullptr, nullptr, noPassword),
                                           EVP_PKEY_free);
    const auto own = readCertificate(certificate), signer = readCertificate(authority);
    const bool together = secret && own && signer && X509_check_private_key(own.get(), secret.get()) == 1 &&
                          X509_verify(own.get(), X509_get0_pubkey(signer.get())) == 1;
    ERR_clear_error();
    return together;
}

}  // namespace pdr::remote
