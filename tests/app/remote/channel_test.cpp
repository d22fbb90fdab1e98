/// What a channel promises: order, room, an end that is told once, and no patience with who breaks the protocol.

#include <QFile>
#include <QSignalSpy>
#include <random>

#include "tests/app/remote/channel_rig.h"
#include "tests/app/wire/example_messages.h"
#include "tests/support/network/random_bytes.h"

using namespace pdr;
using namespace pdr::remote;
using namespace pdr::test;
using std::chrono::milliseconds;

namespace {

constexpr qint64 kMiB = 1 << 20;

wire::Chunk chunkOf(qint64 bytes, std::uint32_t index) {
    return {.index = index, .rawBytes = wire::kChunkBytes, .packed = randomBytes(std::size_t(bytes), index)};
}

wire::SceneOrder orderOf(std::size_t textBytes) {
    wire::SceneOrder order = exampleOrder();
    order.text = std::string(textBytes, 'x');
    return order;
}

/// Returns the resident memory of this program [bytes].
qint64 residentBytes() {
    QFile file("/proc/self/statm");
    return file.open(QFile::ReadOnly) ? file.readAll().split(' ').at(1).toLongLong() * 4096 : 0;
}

}  // namespace

class ChannelTest : public QObject {
    Q_OBJECT

  private slots:
    void messagesArriveInOrder() {
        Rig rig;
        rig.channel->setAdmitted();
        const Reading reading(rig.socket);
        for (std::uint64_t number = 0; number < 1000; ++number) {
            QVERIFY(rig.channel->send(wire::Ping{number}));
            rig.say(wire::Message(wire::Pong{number}));
        }
        QTRY_VERIFY_WITH_TIMEOUT(reading.messages.size() == 1000 && rig.received.size() == 1000, kPatience);
        for (std::uint64_t number = 0; number < 1000; ++number) {
            QCOMPARE(std::get<wire::Ping>(reading.messages[number]).number, number);
            QCOMPARE(std::get<wire::Pong>(rig.received[number]).number, number);
        }
        QCOMPARE(rig.channel->queuedBytes(), 0);
    }

    void whatIsUrgentOvertakesChunks() {
        Rig rig;
        for (std::uint32_t index = 0; index < 3; ++index)
            QVERIFY(rig.channel->send(chunkOf(kMiB, index)));
        QVERIFY(rig.channel->send(wire::Ping{7}));
        QVERIFY(rig.channel->send(wire::Ping{8}));
        const Reading reading(rig.socket);
        QTRY_COMPARE_WITH_TIMEOUT(reading.messages.size(), std::size_t(5), kPatience);
        // The first chunk was on its way.
        QCOMPARE(std::get<wire::Chunk>(reading.messages[0]).index, 0u);
        QCOMPARE(std::get<wire::Ping>(reading.messages[1]).number, std::uint64_t(7));
        QCOMPARE(std::get<wire::Ping>(reading.messages[2]).number, std::uint64_t(8));
        QVERIFY(std::get<wire::Chunk>(reading.messages[3]) == chunkOf(kMiB, 1));
        QVERIFY(std::get<wire::Chunk>(reading.messages[4]) == chunkOf(kMiB, 2));
    }

    void whoDoesNotReadCostsNoMoreThan8MiB() {
        constexpr int kStalled = 8;
        std::vector<std::unique_ptr<Rig>> rigs;
        for (int i = 0; i < kStalled; ++i) {
            rigs.push_back(std::make_unique<Rig>());
            rigs.back()->socket.setReadBufferSize(1);
        }
        const wire::Chunk chunk = chunkOf(wire::kChunkBytes, 0);
        const qint64 before = residentBytes();
        for (std::uint32_t index = 0; index < 25; ++index)
            for (const auto& rig : rigs) {
                const bool room = rig->channel->hasRoom();
                QCOMPARE(rig->channel->send(chunk), room);
                QVERIFY(rig->channel->queuedBytes() <= 8 * kMiB + 4096);
                QVERIFY(rig->channel->send(wire::Ping{index}));  // goes all the same
                QCoreApplication::processEvents();
            }
        const qint64 grown = residentBytes() - before;
        qInfo("%.1f MiB more for each of %d", double(grown) / kStalled / kMiB, kStalled);
#if !defined(__SANITIZE_ADDRESS__)  // which keeps what was freed
        QVERIFY(grown < kStalled * 16 * kMiB);
#endif
    }

    void thereIsRoomAgainWhenTheOtherSideReads() {
        Rig rig;
        rig.socket.setReadBufferSize(1);
        std::uint32_t sent = 0;
        QSignalSpy room(rig.channel.get(), &Channel::roomForMore);
        while (rig.channel->hasRoom() || QTest::qWaitFor([&] { return rig.channel->hasRoom(); }, 50))
            QVERIFY(rig.channel->send(chunkOf(2 * kMiB, sent++)));
        QVERIFY(!rig.channel->send(chunkOf(1, 0)));
        const qsizetype before = room.count();
        rig.socket.setReadBufferSize(0);
        const Reading reading(rig.socket);
        QTRY_COMPARE_WITH_TIMEOUT(room.count(), before + 1, kPatience);
        QVERIFY(rig.channel->send(chunkOf(2 * kMiB, sent++)));
        QTRY_COMPARE_WITH_TIMEOUT(reading.messages.size(), std::size_t(sent), kPatience);
        for (std::uint32_t index = 0; index < sent; ++index)
            QVERIFY(std::get<wire::Chunk>(reading.messages[index]) == chunkOf(2 * kMiB, index));
    }

    void whoTakesNothingAtAllIsGivenUp() {
        Rig rig;
        rig.socket.setReadBufferSize(1);
        const wire::SceneOrder order = orderOf(wire::kMostTextBytes);
        int taken = 0;
        while (rig.channel->send(order))
            QVERIFY(++taken < 10);
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QVERIFY(rig.reason.contains("too little"));
        QCOMPARE(rig.channel->queuedBytes(), 0);
    }

    void whoDripsIsSentAway() {
        ChannelLimits limits = Meeting::patientLimits().channel;
        limits.drip.window = milliseconds(1200);
        Rig rig(limits);
        const wire::Bytes frame = wire::inOnePiece(wire::encode(wire::Hello{.program = std::string(60, 'x')}));
        std::size_t said = 0;
        while (rig.ends == 0 && said < frame.size()) {
            rig.say(wire::Bytes{frame[said++]});
            QTest::qWait(50);
        }
        QCOMPARE(rig.ends, 1);
        QVERIFY(rig.reason.contains("slowly"));
        QVERIFY(rig.received.empty());
    }

    void aCutAnywhereLeavesWhatWasWhole() {
        const wire::Bytes ping = wire::inOnePiece(wire::encode(wire::Need{.from = 9}));
        wire::Bytes all;
        for (int i = 0; i < 20; ++i)
            all.insert(all.end(), ping.begin(), ping.end());
        std::mt19937 random(5);
        for (int round = 0; round < 60; ++round) {
            Rig rig;
            rig.channel->setAdmitted();
            const std::size_t cut = random() % all.size();
            rig.say(wire::Bytes(all.begin(), all.begin() + std::ptrdiff_t(cut)));
            rig.socket.disconnectFromHost();
            QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
            QCOMPARE(rig.received.size(), cut / ping.size());
            QVERIFY(!rig.channel->isOpen() && !rig.channel->send(wire::Ping{}));
        }
    }

    void whatMakesNoSenseEndsIt_data() {
        QTest::addColumn<wire::Bytes>("bytes");
        wire::Bytes damaged = wire::inOnePiece(wire::encode(wire::Hello{.name = "ZZCANARY"}));
        damaged[0] ^= std::byte(1);
        QTest::addRow("no frame") << damaged;
        damaged[0] ^= std::byte(1);
        damaged[33] ^= std::byte(0xff);
        QTest::addRow("no map") << damaged;
        QTest::addRow("what nodes do not say") << wire::inOnePiece(wire::encode(wire::Ping{}));
        const auto header = [](const wire::FrameHeader& of) {
            const auto bytes = wire::bytesOf(of);
            return wire::Bytes(bytes.begin(), bytes.end());
        };
        QTest::addRow("a kind that must be understood") << header({.type = wire::kFirstCritical});
        QTest::addRow("another layout") << header({.version = wire::kLayoutVersion + 1, .type = 1});
        QTest::addRow("not introduced") << wire::inOnePiece(wire::encode(wire::Need{}));
    }
    void whatMakesNoSenseEndsIt() {
        QFETCH(wire::Bytes, bytes);
        Rig rig;
        rig.say(bytes);
        rig.say(wire::Message(wire::Hello{}));
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QVERIFY(rig.received.empty());
        QVERIFY(!rig.reason.contains("CANARY"));
        qInfo("%s", qPrintable(rig.reason));
    }

    void whoDoesNotIntroduceItselfIsSentAway() {
        ChannelLimits limits = Meeting::patientLimits().channel;
        limits.admission = milliseconds(50);
        Rig silent(limits), known(limits);
        known.channel->setAdmitted();
        QTRY_COMPARE_WITH_TIMEOUT(silent.ends, 1, kPatience);
        QVERIFY(silent.reason.contains("introduce"));
        QVERIFY(known.channel->isOpen());
    }

    void theLastMessagesGoOut() {
        Rig rig;
        QVERIFY(rig.channel->send(orderOf(3 * kMiB)));
        QVERIFY(rig.channel->send(wire::Bye{"enough"}));
        rig.channel->close("we are through");
        rig.channel->close("again");
        QCOMPARE(rig.ends, 0);
        QVERIFY(!rig.channel->send(wire::Ping{}));
        const Reading reading(rig.socket);
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(reading.messages.size(), std::size_t(2), kPatience);
        QCOMPARE(std::get<wire::Bye>(reading.messages[1]).reason, std::string("enough"));
        QCOMPARE(rig.reason, QString("we are through"));
    }

    void aFarewellThatNobodyTakesEndsAllTheSame() {
        ChannelLimits limits = Meeting::patientLimits().channel;
        limits.farewell = milliseconds(50);
        Rig rig(limits);
        rig.socket.setReadBufferSize(1);
        while (rig.channel->hasRoom())
            QVERIFY(rig.channel->send(orderOf(wire::kMostTextBytes)));
        rig.channel->close("we are through");
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QCOMPARE(rig.reason, QString("we are through"));
    }

    void itsEndIsToldOnce() {
        Rig rig;
        rig.say(wire::Message(wire::Hello{}));
        rig.socket.abort();
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        rig.channel->close("later");
        QTest::qWait(50);
        QCOMPARE(rig.ends, 1);
    }

    void nothingIsReceivedBehindAClose() {
        Rig rig;
        QObject::connect(rig.channel.get(), &Channel::received, rig.channel.get(),
                         [&] { rig.channel->close("one is enough"); });
        for (int i = 0; i < 5; ++i)
            rig.say(wire::Message(wire::Hello{}));
        QTRY_COMPARE_WITH_TIMEOUT(rig.ends, 1, kPatience);
        QCOMPARE(rig.received.size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(ChannelTest)
#include "channel_test.moc"
