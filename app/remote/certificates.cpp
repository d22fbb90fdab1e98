#include "app/remote/certificates.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QUuid>
#include <vector>

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

/// A part of a bundle: its folder, and its owner.
struct Part {
    Role role;
    QString suffix;  ///< "-3": it is the third node's alone

    QString folder() const { return folderOf(role) + suffix; }
    QString name() const { return nameIn(role) + suffix; }
};

std::vector<Part> partsOf(int nodes) {
    std::vector<Part> parts{{Role::coordinator, ""}};
    if (nodes == 0)
        parts.push_back({Role::node, ""});
    for (int node = 1; node <= nodes; ++node)
        parts.push_back({Role::node, "-" + QString::number(node)});
    return parts;
}

/// Writes all parts of a bundle into an existing folder.
Result<void> writeBundle(const QString& folder, const std::vector<Part>& parts,
                         std::chrono::system_clock::time_point now) {
    const auto from = now - std::chrono::days(1);
    const auto order = [&](const QString& name, const QString& dnsName) {
        return CertificateOrder{name, dnsName, false, from, from + kCertificatesHold};
    };
    // A unique name: a certificate of another bundle is then reported as one of a stranger, not as damaged.
    CertificateOrder ofAuthority = order("PD-Render " + QUuid::createUuid().toString(QUuid::WithoutBraces), "");
    ofAuthority.authority = true;
    const auto authority = makeCertificate(ofAuthority);
    if (!authority)
        return authority.error();
    for (const Part& part : parts) {
        const auto own = makeCertificate(order(part.name(), nameIn(part.role)), &authority.value());
        if (!own)
            return own.error();
        if (auto written = writePart(folder + "/" + part.folder(), *authority, *own); !written)
            return written;
    }
    return {};
}

/// Moves the parts of a bundle one after the other; if one cannot be moved, those before are removed.
bool moveParts(const std::vector<Part>& parts, const QDir& from, const QDir& to) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (QFile::rename(from.filePath(parts[i].folder()), to.filePath(parts[i].folder())))
            continue;
        for (std::size_t before = 0; before < i; ++before)
            QDir(to.filePath(parts[before].folder())).removeRecursively();
        return false;
    }
    return true;
}

/// Returns whether there is a part of a bundle in the folder.
bool hasParts(const QDir& folder) {
    const QString node = folderOf(Role::node);
    return folder.exists(folderOf(Role::coordinator)) || folder.exists(node) || folder.exists(node + "-1");
}

bool makeFolder(const QString& folder) {
    const QString path = QDir::cleanPath(folder);  // without a slash at its end
    return QDir(path).exists() || (QDir().mkpath(QFileInfo(path).absolutePath()) && QDir().mkdir(path, kOwnerFolder));
}

}  // namespace

Result<void> makeCertificates(const QString& folder, int nodes, std::chrono::system_clock::time_point now) {
    const QDir bundle(folder);
    if (hasParts(bundle))
        return Error{phrase("there are certificates already"), folder.toStdString(),
                     phrase("Choose another folder, or delete this one first: nodes that have the old ones are "
                            "strangers then."),
                     ErrorKind::refused};
    const bool isNew = !bundle.exists();
    if (!makeFolder(folder))
        return cannotWrite(folder);
    const std::vector<Part> parts = partsOf(nodes);
    QTemporaryDir scratch(bundle.filePath("making-XXXXXX"));
    auto written = scratch.isValid() ? writeBundle(scratch.path(), parts, now) : cannotWrite(folder);
    if (written && !moveParts(parts, QDir(scratch.path()), bundle))
        written = cannotWrite(folder);
    scratch.remove();
    if (!written && isNew)
        QDir().rmdir(folder);
    return written;
}

}  // namespace pdr::remote
