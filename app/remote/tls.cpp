#include "app/remote/tls.h"

#include <unistd.h>

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QSslKey>
#include <algorithm>

#include "app/remote/signed_certificate.h"
#include "render/base/plain_file.h"

namespace pdr::remote {
namespace {

constexpr std::uint64_t kMostBytes = 64 << 10;

/// Hint for certificates that cannot be used.
Text makeNewOnes() {
    return phrase("Make new ones with --make-certificates, for the coordinator and all nodes.");
}

Error refused(Text what, const QString& where, Text hint) {
    return {std::move(what), where.toStdString(), std::move(hint), ErrorKind::refused};
}

Result<QByteArray> readPem(const QString& path) {
    const Result<std::string> bytes = readPlainFile(QFile::encodeName(path).toStdString(), kMostBytes);
    if (!bytes)
        return refused(bytes.error().what, path, phrase("Give the folder that --make-certificates has made."));
    return QByteArray::fromStdString(*bytes);
}

/// Checks that only the user can read the key. Keys that the system provides (Kubernetes, systemd) belong to root, and
/// the program's group may read them.
Result<void> checkSecrecy(const QString& path) {
    const QFileInfo file(path);
    const bool isHandedOut = file.ownerId() == 0 && geteuid() != 0;
    const auto group = isHandedOut ? QFile::Permissions(QFile::WriteGroup) : QFile::ReadGroup | QFile::WriteGroup;
    if (file.permissions() & (group | QFile::ReadOther | QFile::WriteOther))
        return refused(phrase("others on this machine may read or change this key"), path,
                       phrase("Make it yours alone: chmod 600."));
    return {};
}

Result<void> checkCertificate(const QSslCertificate& certificate, Role role, const QString& path) {
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (certificate.isNull())
        return refused(phrase("this is no certificate"), path, makeNewOnes());
    if (!isOf(certificate, role))
        return refused(phrase("this is not the certificate of a %1", folderOf(role).toStdString()), path,
                       phrase("Give the part of the bundle named %1.", folderOf(role).toStdString()));
    if (now > certificate.expiryDate())
        return refused(phrase("this certificate has expired"), path, makeNewOnes());
    if (now < certificate.effectiveDate())
        return refused(phrase("this certificate does not hold yet"), path, phrase("Check this machine's clock."));
    return {};
}

Result<void> checkKey(const QByteArray& pem, const QString& path) {
    if (pem.contains("ENCRYPTED"))
        return refused(phrase("this key is encrypted, and nobody is there to ask for its password"), path,
                       phrase("Give one without a password, which only you may read."));
    if (QSslKey(pem, QSsl::Ec).isNull())
        return refused(phrase("this is no key"), path, makeNewOnes());
    return {};
}

/// Reads the names of revoked certificates; lines that begin with # are remarks. Without the file none is revoked.
Result<QStringList> readRevoked(const QString& path) {
    if (!QFileInfo::exists(path))
        return QStringList();
    const Result<std::string> text = readPlainFile(QFile::encodeName(path).toStdString(), kMostBytes);
    if (!text)
        return refused(text.error().what, path, phrase("Without it, it is not known who is shut out."));
    QStringList names;
    for (const QString& line : QString::fromStdString(*text).split('\n'))
        if (const QString name = line.trimmed(); !name.isEmpty() && !name.startsWith('#'))
            names << name;
    return names;
}

QString commonName(const QSslCertificate& certificate) {
    return certificate.subjectInfo(QSslCertificate::CommonName).join(' ');
}

}  // namespace

QSslConfiguration tlsConfiguration(const QList<QSslCertificate>& authorities, const QList<QSslCertificate>& chain,
                                   const QSslKey& key) {
    QSslConfiguration tls = QSslConfiguration::defaultConfiguration();
    tls.setProtocol(QSsl::TlsV1_3OrLater);
    tls.setPeerVerifyMode(QSslSocket::VerifyPeer);  // not the default of a side that listens
    tls.setCaCertificates(authorities);             // in place of the system's
    tls.setLocalCertificateChain(chain);
    tls.setPrivateKey(key);
    tls.setSslOption(QSsl::SslOptionDisableSessionSharing, true);  // every connection shows its certificates
    tls.setSslOption(QSsl::SslOptionDisableSessionTickets, true);
    tls.setSslOption(QSsl::SslOptionDisableSessionPersistence, true);
    return tls;
}

Result<Identity> readIdentity(const QString& folder, Role role) {
    const QString part = QFileInfo(folder + "/certificate.pem").exists() ? folder : folder + "/" + folderOf(role);
    const auto authority = readPem(part + "/ca.pem"), own = readPem(part + "/certificate.pem"),
               key = readPem(part + "/key.pem");
    for (const auto* file : {&own, &authority, &key})
        if (!*file)
            return file->error();
    if (auto safe = checkSecrecy(part + "/key.pem"); !safe)
        return safe.error();
    const QSslCertificate certificate(*own);
    if (auto right = checkCertificate(certificate, role, part + "/certificate.pem"); !right)
        return right.error();
    if (auto right = checkKey(*key, part + "/key.pem"); !right)
        return right.error();
    if (QSslCertificate(*authority).isNull())
        return refused(phrase("this is no certificate"), part + "/ca.pem", makeNewOnes());
    if (!belongTogether(*key, *own, *authority))
        return refused(phrase("these certificates do not belong together"), part, makeNewOnes());
    const auto revoked = readRevoked(part + "/revoked.txt");
    if (!revoked)
        return revoked.error();
    return Identity{role,
                    tlsConfiguration(QSslCertificate::fromData(*authority), {certificate}, QSslKey(*key, QSsl::Ec)),
                    *revoked};
}

Result<Identity> identityFor(const Address& address, const QString& folder, Role role) {
    if (!folder.isEmpty())
        return readIdentity(folder, role);
    if (address.isLoopback())
        return Identity{role, std::nullopt, {}};
    return refused(phrase("other machines are only talked to with certificates"), address.text(),
                   phrase("Make some with \"pdrender-node --make-certificates FOLDER\", and give them to both sides: "
                          "--bundle, or the "
                          "window's Certificates."));
}

bool isOf(const QSslCertificate& certificate, Role role) {
    return certificate.subjectAlternativeNames().values(QSsl::DnsEntry) == QStringList{nameIn(role)};
}

QString ownName(const QSslCertificate& certificate) {
    const QString name = commonName(certificate);
    return name.startsWith(nameIn(Role::node) + "-") ? name : QString();
}

Text whyNot(const QSslCertificate& peer, const Identity& self) {
    if (!isOf(peer, other(self.role)))
        return phrase("its certificate is not that of a %1", folderOf(other(self.role)).toStdString());
    if (self.revoked.contains(commonName(peer)))
        return phrase("its certificate, %1, is revoked", commonName(peer).toStdString());
    return {};
}

Text whyUnbelieved(const QList<QSslError>& errors, const QSslCertificate& peer, const Identity& self) {
    const auto hasExpired = [now = QDateTime::currentDateTimeUtc()](const QSslCertificate& certificate) {
        return now > certificate.expiryDate();
    };
    // Without a valid authority, TLS only says that it does not know the peer's.
    if (std::ranges::any_of(self.tls->caCertificates() + self.tls->localCertificateChain(), hasExpired))
        return phrase(
            "this machine's certificates have expired: make new ones for the coordinator and all nodes, and "
            "start the programs again");
    if (!peer.isNull() && hasExpired(peer))
        return phrase("its certificate has expired");
    return phrase("its certificate is not believed: %1", errors.front().errorString().toStdString());
}

}  // namespace pdr::remote
