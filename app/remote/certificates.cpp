#include "app/remote/certificates.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QUuid>

#include "app/remote/role.h"
#include "app/remote/signed_certificate.h"

namespace pdr::remote {
namespace {

constexpr QFile::Permissions kOwnerFile = QFile::ReadOwner | QFile::WriteOwner;
constexpr QFile::Permissions kOwnerFolder = kOwnerFile | QFile::ExeOwner;

Error cannotWrite(const QString& path) {
    return {phrase("the certificates cannot be written"), path.toStdString(), phrase("Choose a folder of your own."),
            ErrorKind::refused};
}

Result<void> write(const QString& path, const QByteArray& text) {
    QFile file(path);
    if (text.isEmpty() || !file.open(QFile::WriteOnly | QFile::NewOnly, kOwnerFile) ||
        file.write(text) != text.size() || !file.flush())
        return cannotWrite(path);
    return {};
}

Result<void> writePart(const QString& folder, const SignedCertificate& authority, const SignedCertificate& own) {
    if (!QDir().mkdir(folder, kOwnerFolder))
        return cannotWrite(folder);
    for (const auto& [name, text] :
         {std::pair("/ca.pem", authority.certificatePem()), std::pair("/certificate.pem", own.certificatePem()),
          std::pair("/key.pem", own.keyPem())})
        if (auto written = write(folder + name, text); !written)
            return written;
    return {};
}

/// Writes both parts of a bundle into an existing folder.
Result<void> writeBundle(const QString& folder, std::chrono::system_clock::time_point now) {
    const auto from = now - std::chrono::days(1);
    const auto order = [&](const QString& name) {
        return CertificateOrder{name, false, from, from + kCertificatesHold};
    };
    // A unique name: a certificate of another bundle is then reported as one of a stranger, not as damaged.
    CertificateOrder ofAuthority = order("PD-Render " + QUuid::createUuid().toString(QUuid::WithoutBraces));
    ofAuthority.authority = true;
    const auto authority = makeCertificate(ofAuthority);
    if (!authority)
        return authority.error();
    for (const Role role : {Role::coordinator, Role::node}) {
        const auto own = makeCertificate(order(nameIn(role)), &authority.value());
        if (!own)
            return own.error();
        if (auto written = writePart(folder + "/" + folderOf(role), *authority, *own); !written)
            return written;
    }
    return {};
}

/// Moves the parts of a bundle one after the other; if the second cannot be moved, the first is removed.
bool moveParts(const QDir& from, const QDir& to) {
    const QString first = folderOf(Role::coordinator), second = folderOf(Role::node);
    if (!QFile::rename(from.filePath(first), to.filePath(first)))
        return false;
    if (QFile::rename(from.filePath(second), to.filePath(second)))
        return true;
    QDir(to.filePath(first)).removeRecursively();
    return false;
}

bool makeFolder(const QString& folder) {
    return QDir(folder).exists() ||
           (QDir().mkpath(QFileInfo(folder).absolutePath()) && QDir().mkdir(folder, kOwnerFolder));
}

}  // namespace

Result<void> makeCertificates(const QString& folder, std::chrono::system_clock::time_point now) {
    const QDir bundle(folder);
    for (const Role role : {Role::coordinator, Role::node})
        if (bundle.exists(folderOf(role)))
            return Error{phrase("there are certificates already"), folder.toStdString(),
                         phrase("Choose another folder, or delete this one first: nodes that have the old ones are "
                                "strangers then."),
                         ErrorKind::refused};
    const bool isNew = !bundle.exists();
    if (!makeFolder(folder))
        return cannotWrite(folder);
    QTemporaryDir scratch(bundle.filePath("making-XXXXXX"));
    auto written = scratch.isValid() ? writeBundle(scratch.path(), now) : cannotWrite(folder);
    if (written && !moveParts(QDir(scratch.path()), bundle))
        written = cannotWrite(folder);
    scratch.remove();
    if (!written && isNew)
        QDir().rmdir(folder);
    return written;
}

}  // namespace pdr::remote
