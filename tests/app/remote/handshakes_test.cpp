/// Who is let in, and who is not.

#include <QSslKey>
#include <QTcpServer>
#include <random>

#include "app/remote/signed_certificate.h"
#include "tests/app/remote/meeting.h"

using namespace pdr;
using namespace pdr::remote;
using namespace pdr::test;
using std::chrono::days;

namespace {

const auto kNow = std::chrono::system_clock::now();

SignedCertificate made(const QString& name, bool authority, const SignedCertificate* issuer, days from = days(-1),
                       days until = days(30), const QString& suffix = "") {
    const auto certificate = makeCertificate({name + suffix, name, authority, kNow + from, kNow + until}, issuer);
    if (!certificate)
        qFatal("%s", certificate.error().text().c_str());
    return *certificate;
}

const SignedCertificate& authority() {
    static const SignedCertificate ours = made("ours", true, nullptr);
    return ours;
}

/// Believes in our authority, and shows that certificate, or none.
Identity showing(Role role, const std::optional<SignedCertificate>& shown) {
    const QList<QSslCertificate> believed{QSslCertificate(authority().certificatePem())};
    if (!shown)
        return {role, tlsConfiguration(believed, {}, {}), {}};
    return {role,
            tlsConfiguration(believed, {QSslCertificate(shown->certificatePem())}, QSslKey(shown->keyPem(), QSsl::Ec)),
            {}};
}

Identity right(Role role) {
    return showing(role, made(nameIn(role), false, &authority()));
}

Identity rogue(Role role) {
    const SignedCertificate theirs = made("ours", true, nullptr);  // of that name, too
    return showing(role, made(nameIn(role), false, &theirs));
}

Identity ofTime(Role role, days from, days until) {
    return showing(role, made(nameIn(role), false, &authority(), from, until));
}

/// Believes in an authority that has expired.
Identity ofOldAuthority(Role role) {
    static const SignedCertificate old = made("ours", true, nullptr, days(-9), days(-1));
    const SignedCertificate own = made(nameIn(role), false, &old);
    return {role,
            tlsConfiguration({QSslCertificate(old.certificatePem())}, {QSslCertificate(own.certificatePem())},
                             QSslKey(own.keyPem(), QSsl::Ec)),
            {}};
}

Identity ofOtherRole(Role role) {
    return showing(role, made(nameIn(other(role)), false, &authority()));
}

/// The third node's, where nodes have certificates of their own.
Identity ofNode3() {
    return showing(Role::node, made(nameIn(Role::node), false, &authority(), days(-1), days(30), "-3"));
}

Identity whoRevokes(const QString& name) {
    Identity identity = right(Role::coordinator);
    identity.revoked << name;
    return identity;
}

Identity ofTls12(Role role) {
    Identity identity = right(role);
    identity.tls->setProtocol(QSsl::TlsV1_2);
    return identity;
}

Identity selfSigned(Role role) {
    return showing(role, made(nameIn(role), false, nullptr));
}

}  // namespace

class HandshakesTest : public QObject {
    Q_OBJECT

  private slots:
    void rightOnesAdmitEachOther_data() {
        QTest::addColumn<int>("listens");
        QTest::addRow("the node dials") << int(Role::coordinator);
        QTest::addRow("the coordinator dials") << int(Role::node);
    }
    void rightOnesAdmitEachOther() {
        QFETCH(int, listens);
        for (const bool encrypted : {true, false}) {
            const auto identity = encrypted ? identityOf : plain;
            Meeting meeting(identity(Role(listens)), identity(other(Role(listens))));
            meeting.begin();
            QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
            QVERIFY2(meeting.listening.admitted && meeting.dialling.admitted, qPrintable(meeting.dialling.reason));
        }
    }

    void aNodeIsKnownByACertificateOfItsOwn() {
        for (const auto& [listens, dials] :
             {std::pair(whoRevokes("pdrender-node-4"), ofNode3()), std::pair(ofNode3(), whoRevokes("pdrender-node"))}) {
            Meeting meeting(listens, dials);
            meeting.begin();
            QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
            QVERIFY2(meeting.listening.admitted && meeting.dialling.admitted, qPrintable(meeting.dialling.reason));
            const bool nodeDials = listens.role == Role::coordinator;
            const Side &coordinator = nodeDials ? meeting.listening : meeting.dialling,
                       &node = nodeDials ? meeting.dialling : meeting.listening;
            QCOMPARE(coordinator.channel->peerCertificate(), QString("pdrender-node-3"));
            QCOMPARE(node.channel->peerCertificate(), QString());
        }
    }

    /// The coordinator listens and the node dials, and then the other way round.
    void wrongOnesAreRefused_data() {
        const Role c = Role::coordinator, n = Role::node;
        QTest::addColumn<Identity>("coordinator");
        QTest::addColumn<Identity>("node");
        QTest::addRow("no client certificate") << right(c) << showing(n, std::nullopt);
        QTest::addRow("rogue client") << right(c) << rogue(n);
        QTest::addRow("rogue server") << rogue(c) << right(n);
        QTest::addRow("expired client") << right(c) << ofTime(n, days(-9), days(-1));
        QTest::addRow("expired server") << ofTime(c, days(-9), days(-1)) << right(n);
        QTest::addRow("client not yet valid") << right(c) << ofTime(n, days(1), days(9));
        QTest::addRow("server not yet valid") << ofTime(c, days(1), days(9)) << right(n);
        QTest::addRow("wrong role as server") << ofOtherRole(c) << right(n);
        QTest::addRow("wrong role as client") << right(c) << ofOtherRole(n);
        QTest::addRow("TLS 1.2 client") << right(c) << ofTls12(n);
        QTest::addRow("TLS 1.2 server") << ofTls12(c) << right(n);
        QTest::addRow("plain TCP to TLS") << right(c) << plain(n);
        QTest::addRow("TLS to plain TCP") << plain(c) << right(n);
        QTest::addRow("self-signed client") << right(c) << selfSigned(n);
        QTest::addRow("self-signed server") << selfSigned(c) << right(n);
        QTest::addRow("revoked node") << whoRevokes("pdrender-node-3") << ofNode3();
        QTest::addRow("revoked nodes") << whoRevokes("pdrender-node") << right(n);
        QTest::addRow("signed by a certificate that signs nothing") << right(c) << signedByNode();
    }
    void wrongOnesAreRefused() {
        QFETCH(Identity, coordinator);
        QFETCH(Identity, node);
        for (const auto& [listens, dials] : {std::pair(coordinator, node), std::pair(node, coordinator)}) {
            ListenerLimits limits = Meeting::patientLimits();
            limits.handshake = std::chrono::seconds(2);  // plain TCP whose listener speaks first waits for it
            Meeting meeting(listens, dials, limits);
            meeting.begin();
            QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
            QVERIFY(!meeting.listening.admitted && !meeting.dialling.admitted);
            QVERIFY(meeting.listening.received.empty() && meeting.dialling.received.empty());
            QCOMPARE(meeting.listening.ends, 1);
            QCOMPARE(meeting.dialling.ends, 1);
            qInfo("%s | %s", qPrintable(meeting.listening.reason), qPrintable(meeting.dialling.reason));
        }
    }

    /// Programs may run longer than their certificates are valid. TLS speaks of a strange authority then.
    void expiredCertificatesAreSaid_data() {
        const Role c = Role::coordinator, n = Role::node;
        QTest::addColumn<Identity>("listens");
        QTest::addColumn<Identity>("dials");
        QTest::addColumn<QString>("listener");
        QTest::addColumn<QString>("dialler");
        const QString ours = "this machine's certificates have expired", theirs = "its certificate has expired";
        QTest::addRow("both sides'") << ofOldAuthority(n) << ofOldAuthority(c) << QString() << ours;
        QTest::addRow("the dialler's") << right(n) << ofTime(c, days(-9), days(-1)) << theirs << QString();
        QTest::addRow("the listener's") << ofTime(n, days(-9), days(-1)) << right(c) << QString() << theirs;
        QTest::addRow("of a stranger") << rogue(n) << right(c) << QString() << QString("not believed");
    }
    void expiredCertificatesAreSaid() {
        QFETCH(Identity, listens);
        QFETCH(Identity, dials);
        QFETCH(QString, listener);
        QFETCH(QString, dialler);
        Meeting meeting(listens, dials);
        meeting.begin();
        QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
        QVERIFY2(meeting.listening.reason.contains(listener), qPrintable(meeting.listening.reason));
        QVERIFY2(meeting.dialling.reason.contains(dialler), qPrintable(meeting.dialling.reason));
    }

    /// Trying again is of no use where the other side is somebody else.
    void aDialKnowsWhetherToTryAgain() {
        Meeting stranger(rogue(Role::coordinator), right(Role::node));
        stranger.begin();
        QTRY_VERIFY_WITH_TIMEOUT(stranger.isSettled(), kPatience);
        QVERIFY(stranger.failure.kind == ErrorKind::refused);

        Meeting nobody(right(Role::coordinator), right(Role::node));
        QTcpServer closedAgain;
        QVERIFY(closedAgain.listen(QHostAddress::LocalHost));
        const quint16 port = closedAgain.serverPort();
        closedAgain.close();
        nobody.begin(port);
        QTRY_COMPARE_WITH_TIMEOUT(nobody.dialling.ends, 1, kPatience);
        QVERIFY(nobody.failure.kind == ErrorKind::failed);
    }

    void garbageIsRefused_data() {
        QTest::addColumn<Identity>("identity");
        QTest::addRow("garbage to TLS") << right(Role::coordinator);
        QTest::addRow("garbage to plain TCP") << plain(Role::coordinator);
    }
    void garbageIsRefused() {
        QFETCH(Identity, identity);
        std::mt19937 random(14);
        for (int round = 0; round < 20; ++round) {
            Meeting meeting(identity, identity);
            QTcpSocket stranger;
            stranger.connectToHost("127.0.0.1", meeting.listener.address().port);
            QVERIFY(stranger.waitForConnected(kPatience));
            QByteArray garbage(4096, 0);
            std::ranges::generate(garbage, [&] { return char(random()); });
            stranger.write(garbage);
            QTRY_COMPARE_WITH_TIMEOUT(meeting.listening.ends, 1, kPatience);
            QVERIFY(meeting.listening.received.empty());
        }
    }

    /// The default of a side that listens, which would let in whoever shows nothing.
    void theListeningSideAsksForACertificate() {
        QCOMPARE(right(Role::coordinator).tls->peerVerifyMode(), QSslSocket::VerifyPeer);
        QCOMPARE(right(Role::node).tls->caCertificates(), {QSslCertificate(authority().certificatePem())});
    }

  private:
    static Identity signedByNode() {
        const SignedCertificate node = made(nameIn(Role::node), false, &authority());
        Identity identity = showing(Role::node, made(nameIn(Role::node), false, &node));
        auto chain = identity.tls->localCertificateChain();
        identity.tls->setLocalCertificateChain(chain << QSslCertificate(node.certificatePem()));
        return identity;
    }
};

QTEST_GUILESS_MAIN(HandshakesTest)
#include "handshakes_test.moc"
