/// Bad networks: what is slow or cut into pieces arrives whole, what is damaged never arrives, and what is broken is
/// noticed.

#include <random>

#include "app/remote/heartbeat.h"
#include "tests/app/remote/meeting.h"
#include "tests/app/wire/example_messages.h"
#include "tests/support/network/fault_proxy.h"
#include "tests/support/network/random_bytes.h"

using namespace pdr;
using namespace pdr::remote;
using namespace pdr::test;
using std::chrono::milliseconds;

namespace {

constexpr int kMessages = 40;

/// A coordinator and a node that know each other, over a bad network.
struct Pair {
    explicit Pair(std::uint64_t seed = 1, const ListenerLimits& limits = Meeting::patientLimits())
        : meeting(identityOf(Role::coordinator), identityOf(Role::node), limits),
          proxy(meeting.listener.address().port, seed) {
        meeting.begin(proxy.port());
    }
    bool isKnown() const { return meeting.listening.admitted && meeting.dialling.admitted; }
    bool isOver() const { return meeting.listening.ends > 0 && meeting.dialling.ends > 0; }
    void send() {
        for (std::uint32_t i = 0; i < kMessages; ++i) {
            meeting.listening.channel->send(chunkOf(i));
            meeting.dialling.channel->send(wire::Need{.from = i});
        }
    }
    static wire::Chunk chunkOf(std::uint32_t index) {
        return {.index = index, .rawBytes = 70000, .packed = randomBytes(10000, index)};
    }
    /// Returns the number of messages that have arrived at both sides after those of the handshake.
    int arrived() const {
        const auto count = [](const Side& side) { return std::max(int(side.received.size()) - 1, 0); };
        return count(meeting.dialling) + count(meeting.listening);
    }
    /// Whether what arrived is what was sent first.
    bool isRight() const {
        const auto& atNode = meeting.dialling.received;
        const auto& atCoordinator = meeting.listening.received;
        for (std::uint32_t i = 1; i < atNode.size(); ++i)
            if (!(std::get<wire::Chunk>(atNode[i]) == chunkOf(i - 1)))
                return false;
        for (std::uint32_t i = 1; i < atCoordinator.size(); ++i)
            if (std::get<wire::Need>(atCoordinator[i]).from != i - 1)
                return false;
        return true;
    }

    Meeting meeting;
    FaultProxy proxy;
};

void setBoth(FaultProxy& proxy, const NetworkFault& fault) {
    proxy.set(Direction::toServer, fault);
    proxy.set(Direction::toClient, fault);
}

}  // namespace

class BadNetworkTest : public QObject {
    Q_OBJECT

  private slots:
    void slowNetworksDeliverAll_data() {
        QTest::addColumn<NetworkFault>("fault");
        QTest::addRow("as it is") << NetworkFault{};
        QTest::addRow("20 ms") << NetworkFault{.delay = milliseconds(20)};
        QTest::addRow("10 Mbit/s") << NetworkFault{.delay = milliseconds(100), .bytesPerSecond = 10'000'000 / 8};
        QTest::addRow("pieces of 1 byte") << NetworkFault{.mostPiece = 1};
        QTest::addRow("pieces of 1 to 700 bytes") << NetworkFault{.mostPiece = 700};
    }
    void slowNetworksDeliverAll() {
        QFETCH(NetworkFault, fault);
        Pair pair;
        setBoth(pair.proxy, fault);
        QTRY_VERIFY_WITH_TIMEOUT(pair.isKnown(), kPatience);
        pair.send();
        QTRY_COMPARE_WITH_TIMEOUT(pair.arrived(), 2 * kMessages, kPatience);
        QVERIFY(pair.isRight());
        QVERIFY(!pair.isOver());
    }

    /// Measures throughput on one thread, so that each side has half of it. What a channel sends is what a scan takes
    /// to reach a node.
    void chunksFlowOverTls() {
        constexpr std::uint32_t kChunks = 64;
        Meeting meeting(identityOf(Role::coordinator), identityOf(Role::node));
        meeting.begin();
        QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
        Channel& sender = *meeting.listening.channel;
        std::uint32_t sent = 0, arrived = 0;
        QObject::connect(
            meeting.dialling.channel.get(), &Channel::received, &sender,
            [&](const wire::Message& message) { arrived += std::get<wire::Chunk>(message).index == arrived; });
        const wire::Chunk chunk{.rawBytes = wire::kChunkBytes, .packed = randomBytes(wire::kChunkBytes, 1)};
        const auto sendSome = [&] {
            for (; sent < kChunks && sender.hasRoom(); ++sent) {
                wire::Chunk next = chunk;
                next.index = sent;
                QVERIFY(sender.send(std::move(next)));
            }
        };
        QObject::connect(&sender, &Channel::roomForMore, &sender, sendSome);
        QElapsedTimer clock;
        clock.start();
        sendSome();
        QTRY_COMPARE_WITH_TIMEOUT(arrived, kChunks, kPatience);
        qInfo("%.0f MiB/s", 4.0 * kChunks / (double(clock.nsecsElapsed()) * 1e-9));
    }

    /// The sender sends more than the sockets hold and ends the connection right behind it.
    void theLastMessagesArriveOverTls() {
        Meeting meeting(identityOf(Role::coordinator), identityOf(Role::node));
        meeting.begin();
        QTRY_VERIFY_WITH_TIMEOUT(meeting.isSettled(), kPatience);
        Channel& sender = *meeting.listening.channel;
        for (std::uint32_t i = 0; i < 3; ++i) {
            wire::SceneOrder order = exampleOrder();
            order.revision = i;
            order.text = std::string(5 << 20, 'x');
            QVERIFY(sender.send(std::move(order)));
        }
        QVERIFY(sender.send(wire::Bye{"enough"}));
        sender.close("we are through");
        QTRY_VERIFY_WITH_TIMEOUT(meeting.listening.ends == 1 && meeting.dialling.ends == 1, kPatience);
        QCOMPARE(meeting.dialling.received.size(), std::size_t(5));
        QCOMPARE(std::get<wire::Bye>(meeting.dialling.received.back()).reason, std::string("enough"));
    }

    void aStallIsWaitedFor() {
        Pair pair;
        QTRY_VERIFY_WITH_TIMEOUT(pair.isKnown(), kPatience);
        setBoth(pair.proxy, {.stall = true});
        pair.send();
        QTest::qWait(300);
        QCOMPARE(pair.arrived(), 0);
        setBoth(pair.proxy, {});
        QTRY_COMPARE_WITH_TIMEOUT(pair.arrived(), 2 * kMessages, kPatience);
        QVERIFY(pair.isRight());
    }

    /// TCP is told that all is well; only the heartbeat notices.
    void aBlackHoleIsSilent() {
        Pair pair;
        QTRY_VERIFY_WITH_TIMEOUT(pair.isKnown(), kPatience);
        setBoth(pair.proxy, {.blackHole = true});
        pair.send();
        Heartbeat heartbeat(milliseconds(0));
        const qint64 before = pair.meeting.listening.channel->bytesReceived();
        auto now = milliseconds(0);
        while (heartbeat.at(now) != Heartbeat::Peer::dead) {
            QTest::qWait(1);
            if (pair.meeting.listening.channel->bytesReceived() != before)
                heartbeat.heard(now);
            now += milliseconds(100);
        }
        QCOMPARE(int(now.count()), 10000);
        QVERIFY(!pair.isOver());
    }

    void aBrokenConnectionEndsOnBothSides_data() {
        QTest::addColumn<QString>("how");
        for (const char* how : {"reset", "end to server", "end to client"})
            QTest::addRow("%s", how) << QString(how);
    }
    void aBrokenConnectionEndsOnBothSides() {
        QFETCH(QString, how);
        Pair pair;
        QTRY_VERIFY_WITH_TIMEOUT(pair.isKnown(), kPatience);
        pair.send();
        if (how == "reset")
            pair.proxy.reset();
        else
            pair.proxy.end(how.endsWith("server") ? Direction::toServer : Direction::toClient);
        QTRY_VERIFY_WITH_TIMEOUT(pair.isOver(), kPatience);
        QVERIFY(pair.isRight());
        QCOMPARE(pair.meeting.listening.ends + pair.meeting.dialling.ends, 2);
        QCOMPARE(pair.proxy.connections(), 1);
    }

    /// Damage may happen in the handshake or behind it: what arrives is what was sent, and both sides learn of the end.
    void damageAnywhereIsNeverDelivered_data() {
        QTest::addColumn<std::optional<qint64> NetworkFault::*>("kind");
        QTest::addRow("a bit is wrong") << &NetworkFault::corrupt;
        QTest::addRow("bytes come twice") << &NetworkFault::duplicate;
        QTest::addRow("it is reset") << &NetworkFault::resetAfter;
        QTest::addRow("one direction ends") << &NetworkFault::endAfter;
    }
    void damageAnywhereIsNeverDelivered() {
        using Kind = std::optional<qint64> NetworkFault::*;
        QFETCH(Kind, kind);
        std::mt19937 random(41);
        int midHandshake = 0;
        for (int round = 0; round < 24; ++round) {
            Pair pair{std::uint64_t(round)};
            const auto direction = round % 2 ? Direction::toServer : Direction::toClient;
            NetworkFault fault;
            // Both directions send about 2,000 bytes before both are admitted, and 4,000 or 400,000 behind it.
            fault.*kind = qint64(random() % (round % 4 < 2 ? 2000 : 5000));
            pair.proxy.set(direction, fault);
            QTRY_VERIFY_WITH_TIMEOUT(pair.isKnown() || pair.isOver(), kPatience);
            midHandshake += !pair.isKnown();
            if (pair.isKnown())
                pair.send();
            QTRY_VERIFY_WITH_TIMEOUT(pair.isOver(), kPatience);
            QVERIFY(pair.isRight());
            QVERIFY(pair.arrived() < 2 * kMessages);
        }
        qInfo("%d of 24 in the handshake", midHandshake);
        QVERIFY(midHandshake > 0 && midHandshake < 24);
    }
};

QTEST_GUILESS_MAIN(BadNetworkTest)
#include "bad_network_test.moc"
