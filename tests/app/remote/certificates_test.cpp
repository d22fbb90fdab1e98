/// What a bundle of certificates holds, and what is made of one.

#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QSslCertificate>
#include <QSslCertificateExtension>
#include <QSslKey>
#include <QTemporaryDir>
#include <QTest>

#include "app/remote/certificates.h"
#include "app/remote/tls.h"
#include "tests/support/file_size_limit.h"

using namespace pdr;
using namespace pdr::remote;
using namespace pdr::test;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

std::shared_ptr<X509> x509Of(const QString& path) {
    const QByteArray pem = contentOf(path);
    const std::shared_ptr<BIO> bio(BIO_new_mem_buf(pem.constData(), int(pem.size())), BIO_free);
    return {PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr), X509_free};
}

/// Verifies a certificate as `openssl verify -x509_strict -purpose ...` does.
bool isBelieved(const QString& part, int purpose) {
    const auto authority = x509Of(part + "/ca.pem"), own = x509Of(part + "/certificate.pem");
    const std::shared_ptr<X509_STORE> store(X509_STORE_new(), X509_STORE_free);
    const std::shared_ptr<X509_STORE_CTX> context(X509_STORE_CTX_new(), X509_STORE_CTX_free);
    X509_STORE_add_cert(store.get(), authority.get());
    X509_STORE_set_flags(store.get(), X509_V_FLAG_X509_STRICT);
    X509_STORE_CTX_init(context.get(), store.get(), own.get(), nullptr);
    X509_STORE_CTX_set_purpose(context.get(), purpose);
    const bool believed = X509_verify_cert(context.get()) == 1;
    if (!believed)
        qInfo("%s", X509_verify_cert_error_string(X509_STORE_CTX_get_error(context.get())));
    return believed;
}

QString refusalOf(const QString& folder, Role role) {
    const auto identity = readIdentity(folder, role);
    return identity ? QString() : QString::fromStdString(identity.error().text());
}

bool overwrite(const QString& path, const QByteArray& content) {
    QFile file(path);
    return file.open(QFile::WriteOnly) && file.write(content) == content.size();
}

}  // namespace

class CertificatesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString bundle_ = folder_.filePath("deep/bundle");

    QString partOf(Role role) const { return bundle_ + "/" + folderOf(role); }
    /// A bundle to be damaged.
    QString another() const {
        static int count = 0;
        const QString folder = folder_.filePath("another" + QString::number(++count));
        return makeCertificates(folder) ? folder : QString();
    }

  private slots:
    void initTestCase() { QVERIFY(makeCertificates(bundle_)); }

    void eachPartHoldsThreeFilesOfItsOwner() {
        for (const Role role : {Role::coordinator, Role::node}) {
            const QDir part(partOf(role));
            QCOMPARE(part.entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
                     (QStringList{"ca.pem", "certificate.pem", "key.pem"}));
            const auto others = ~(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner | QFile::ReadUser |
                                  QFile::WriteUser | QFile::ExeUser);
            for (const QString& path : {part.filePath("key.pem"), part.path(), bundle_})
                QVERIFY2(!(QFile::permissions(path) & others), qPrintable(path));
            QVERIFY(!(QFile::permissions(part.filePath("key.pem")) & QFile::ExeOwner));
        }
        QCOMPARE(QDir(bundle_).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
                 (QStringList{"coordinator", "node"}));
    }

    void certificatesAreWhatTheySay() {
        for (const Role role : {Role::coordinator, Role::node}) {
            const auto own = x509Of(partOf(role) + "/certificate.pem");
            QVERIFY(own);
            QCOMPARE(X509_get_extended_key_usage(own.get()), XKU_SSL_SERVER | XKU_SSL_CLIENT);
            QCOMPARE(X509_get_key_usage(own.get()), KU_DIGITAL_SIGNATURE);
            QCOMPARE(X509_check_ca(own.get()), 0);
            QCOMPARE(X509_check_host(own.get(), nameIn(role).toLatin1(), 0, 0, nullptr), 1);
            QCOMPARE(X509_check_host(own.get(), nameIn(other(role)).toLatin1(), 0, 0, nullptr), 0);
            char group[32] = "";
            EVP_PKEY_get_group_name(X509_get0_pubkey(own.get()), group, sizeof group, nullptr);
            QCOMPARE(group, "prime256v1");
            const QSslCertificate certificate(contentOf(partOf(role) + "/certificate.pem"));
            QCOMPARE(certificate.effectiveDate().daysTo(certificate.expiryDate()), qint64(825));
            const qint64 age = certificate.effectiveDate().secsTo(QDateTime::currentDateTimeUtc());
            QVERIFY(age >= 86400 && age < 2 * 86400);
        }
        const auto authority = x509Of(partOf(Role::node) + "/ca.pem");
        QCOMPARE(X509_check_ca(authority.get()), 1);
        QCOMPARE(X509_get_pathlen(authority.get()), 0l);
        QCOMPARE(contentOf(partOf(Role::node) + "/ca.pem"), contentOf(partOf(Role::coordinator) + "/ca.pem"));
    }

    void opensslBelievesThemBothWays() {
        for (const Role role : {Role::coordinator, Role::node})
            for (const int purpose : {X509_PURPOSE_SSL_SERVER, X509_PURPOSE_SSL_CLIENT})
                QVERIFY(isBelieved(partOf(role), purpose));
    }

    /// Nobody can sign a third certificate.
    void theAuthoritysKeyIsForgotten() {
        const auto authority = x509Of(partOf(Role::node) + "/ca.pem");
        for (const Role role : {Role::coordinator, Role::node}) {
            const QByteArray pem = contentOf(partOf(role) + "/key.pem");
            const std::shared_ptr<BIO> bio(BIO_new_mem_buf(pem.constData(), int(pem.size())), BIO_free);
            const std::shared_ptr<EVP_PKEY> key(PEM_read_bio_PrivateKey(bio.get(), nullptr, nullptr, nullptr),
                                                EVP_PKEY_free);
            QVERIFY(key);
            QCOMPARE(X509_check_private_key(authority.get(), key.get()), 0);
        }
    }

    void eachNodeMayHaveOneOfItsOwn() {
        const QString folder = folder_.filePath("own");
        QVERIFY(makeCertificates(folder, 3));
        QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
                 (QStringList{"coordinator", "node-1", "node-2", "node-3"}));
        QSet<QByteArray> keys;
        for (const char* part : {"/node-1", "/node-2", "/node-3"}) {
            const auto identity = readIdentity(folder + part, Role::node);
            QVERIFY2(identity, identity ? "" : identity.error().text().c_str());
            QCOMPARE(ownName(identity->tls->localCertificate()), QString("pdrender-node-") + part[6]);
            QVERIFY(isBelieved(folder + part, X509_PURPOSE_SSL_SERVER));
            keys << contentOf(folder + part + "/key.pem");
        }
        QCOMPARE(keys.size(), 3);
        QCOMPARE(ownName(readIdentity(bundle_, Role::node)->tls->localCertificate()), QString());
        QVERIFY(!makeCertificates(folder) && !makeCertificates(folder, 3));
    }

    void revokedCertificatesAreNamedInAList() {
        const QString folder = another(), list = folder + "/coordinator/revoked.txt";
        QVERIFY(readIdentity(folder, Role::coordinator)->revoked.isEmpty());
        QVERIFY(overwrite(list, "# stolen in March\n\n pdrender-node-3\r\npdrender-node-12"));
        QCOMPARE(readIdentity(folder, Role::coordinator)->revoked,
                 (QStringList{"pdrender-node-3", "pdrender-node-12"}));
        QVERIFY(QFile::remove(list) && ::mkfifo(QFile::encodeName(list).constData(), 0600) == 0);
        QVERIFY(refusalOf(folder, Role::coordinator).contains("revoked.txt: this is no plain file"));
    }

    void aBundleIsNotOverwritten() {
        const QByteArray before = contentOf(partOf(Role::node) + "/key.pem");
        const auto again = makeCertificates(bundle_);
        QVERIFY(!again && again.error().what.find("already") != std::string::npos);
        QCOMPARE(contentOf(partOf(Role::node) + "/key.pem"), before);
    }

    void allIsWrittenOrNothing() {
        for (const rlim_t bytes : {0, 100, 500, 600, 800}) {
            const QString folder = folder_.filePath("too/small");
            const bool made = [&] {
                const FileSizeLimit limit(bytes);
                return bool(makeCertificates(folder));
            }();
            QCOMPARE(QDir(folder).exists(), made);
            QCOMPARE(QFile::exists(folder + "/node/key.pem"), made);
            QDir(folder).removeRecursively();
        }
        QVERIFY(overwrite(folder_.filePath("file"), "x"));
        QVERIFY(!makeCertificates(folder_.filePath("file/bundle")));
    }

    void aBundleMakesAnIdentity() {
        for (const Role role : {Role::coordinator, Role::node})
            for (const QString& folder : {bundle_, partOf(role)}) {
                const auto identity = readIdentity(folder, role);
                QVERIFY2(identity, identity ? "" : identity.error().text().c_str());
                QVERIFY(identity->role == role);
                QCOMPARE(identity->tls->protocol(), QSsl::TlsV1_3OrLater);
                QCOMPARE(identity->tls->peerVerifyMode(), QSslSocket::VerifyPeer);
                QCOMPARE(identity->tls->caCertificates().size(), 1);
                QVERIFY(!identity->tls->privateKey().isNull());
            }
    }

    void aKeyThatOthersMayReadIsRefused() {
        const QString folder = another();
        const auto owner = QFile::ReadOwner | QFile::WriteOwner;
        for (const auto more : {QFile::ReadGroup, QFile::ReadOther, QFile::WriteGroup, QFile::WriteOther}) {
            QVERIFY(QFile::setPermissions(folder + "/node/key.pem", owner | more));
            QVERIFY(refusalOf(folder, Role::node).contains("others on this machine"));
        }
        QVERIFY(QFile::setPermissions(folder + "/node/key.pem", QFile::ReadOwner));
        QCOMPARE(refusalOf(folder, Role::node), QString());
    }

    /// Kubernetes and systemd hand out keys of root that the group may read.
    void aKeyOfRootsMayBeReadByTheGroup() {
        if (geteuid() != 0)
            QSKIP("only root can hand out keys");
        const QString folder = another();
        for (const char* part : {"", "/node"})
            QVERIFY(QFile::setPermissions(folder + part, QFile::Permissions(0x7755)));
        QVERIFY(QFile::setPermissions(folder_.path(), QFile::Permissions(0x7755)));
        for (const char* file : {"/node/ca.pem", "/node/certificate.pem"})
            QVERIFY(QFile::setPermissions(folder + file, QFile::Permissions(0x6644)));
        QVERIFY(QFile::setPermissions(folder + "/node/key.pem", QFile::Permissions(0x6640)));
        const auto refusalOfSomebody = [&] {
            const bool left = setegid(0) == 0 && seteuid(1) == 0;
            const QString refusal = refusalOf(folder, Role::node);
            return left && seteuid(0) == 0 ? refusal : "cannot be somebody";
        };
        QCOMPARE(refusalOfSomebody(), QString());
        QVERIFY(refusalOf(folder, Role::node).contains("others on this machine"));  // root's own
        for (const int more : {0x6660, 0x6644}) {
            QVERIFY(QFile::setPermissions(folder + "/node/key.pem", QFile::Permissions(more)));
            QVERIFY(refusalOfSomebody().contains("others on this machine"));
        }
        QVERIFY(chown(QFile::encodeName(folder + "/node/key.pem").constData(), 1, 0) == 0);
        QVERIFY(QFile::setPermissions(folder + "/node/key.pem", QFile::Permissions(0x6640)));
        QVERIFY(refusalOfSomebody().contains("others on this machine"));
    }

    void badBundlesAreRefusedWithASentence() {
        QVERIFY(refusalOf(partOf(Role::coordinator), Role::node).contains("not the certificate of a node"));
        QVERIFY(refusalOf(folder_.filePath("nowhere"), Role::node).contains("cannot be read"));
        const QString mixed = another();
        QVERIFY(overwrite(mixed + "/node/ca.pem", contentOf(bundle_ + "/node/ca.pem")));
        QVERIFY(overwrite(mixed + "/coordinator/key.pem", contentOf(bundle_ + "/coordinator/key.pem")));
        for (const Role role : {Role::coordinator, Role::node})
            QVERIFY(refusalOf(mixed, role).contains("do not belong together"));
        // Which file it is, is said: a key with a password, one of something else, and what nobody will ever write.
        const QString sealed = another();
        const QString key = sealed + "/node/key.pem";
        QVERIFY(overwrite(key, "-----BEGIN ENCRYPTED PRIVATE KEY-----\nAAAA\n-----END ENCRYPTED PRIVATE KEY-----\n"));
        QVERIFY(refusalOf(sealed, Role::node).contains("key.pem: this key is encrypted"));
        QVERIFY(overwrite(key, "nothing"));
        QVERIFY(refusalOf(sealed, Role::node).contains("key.pem: this is no key"));
        const QString alone = another();
        QVERIFY(overwrite(alone + "/node/ca.pem", "nothing"));
        QVERIFY(refusalOf(alone, Role::node).contains("ca.pem: this is no certificate"));
        for (const char* name : {"ca.pem", "certificate.pem", "key.pem"}) {
            const QString piped = another(), file = piped + "/node/" + name;
            QVERIFY(QFile::remove(file) && ::mkfifo(QFile::encodeName(file).constData(), 0600) == 0);
            QVERIFY(refusalOf(piped, Role::node).contains(QString(name) + ": this is no plain file"));
        }
        QVERIFY(overwrite(mixed + "/node/certificate.pem", "nothing"));
        QVERIFY(refusalOf(mixed, Role::node).contains("no certificate"));

        const auto now = std::chrono::system_clock::now();
        const QString old = folder_.filePath("old"), early = folder_.filePath("early");
        QVERIFY(makeCertificates(old, 0, now - kCertificatesHold));
        QVERIFY(refusalOf(old, Role::node).contains("expired"));
        QVERIFY(makeCertificates(early, 0, now + std::chrono::days(2)));
        QVERIFY(refusalOf(early, Role::node).contains("not hold yet"));
    }

    /// Without certificates, a program talks to its own machine only.
    void plainTcpStaysOnThisMachine() {
        QVERIFY(!identityFor({"127.0.0.1", 1}, "", Role::node)->tls);
        QVERIFY(identityFor({"127.0.0.1", 1}, bundle_, Role::node)->tls);
        QVERIFY(identityFor({"192.0.2.7", 1}, bundle_, Role::node)->tls);
        for (const char* host : {"192.0.2.7", "", "0.0.0.0", "example.com"}) {
            const auto identity = identityFor({host, 1}, "", Role::node);
            QVERIFY(!identity && identity.error().hint.find("--make-certificates") != std::string::npos);
        }
    }
};

QTEST_GUILESS_MAIN(CertificatesTest)
#include "certificates_test.moc"
