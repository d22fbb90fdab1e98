/// Frames in whatever pieces they come, and what is no frame.

#include <QTest>

#include "tests/app/wire/frame_hand.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

/// All that a node may hear, and all that a coordinator may hear, one behind the other.
std::pair<std::vector<Message>, Bytes> talkTo(Role reader) {
    std::vector<Message> messages;
    Bytes bytes;
    for (const Message& message : test::exampleMessages())
        if (test::readerOf(message) == reader) {
            const Bytes frame = inOnePiece(encode(message));
            bytes.insert(bytes.end(), frame.begin(), frame.end());
            messages.push_back(message);
        }
    return {messages, bytes};
}

bool same(const std::vector<Message>& a, const std::vector<Message>& b) {
    return std::ranges::equal(a, b, [](const Message& x, const Message& y) { return test::same(x, y); });
}

Bytes frameOf(const FrameHeader& header, std::size_t bodyBytes) {
    const auto head = wire::bytesOf(header);
    Bytes bytes(head.begin(), head.end());
    bytes.resize(bytes.size() + bodyBytes);
    return bytes;
}

/// A Ping without a checksum, with a byte of its header changed.
test::Heard heardPing(std::size_t place, int value) {
    Bytes bytes = test::unchecked(inOnePiece(encode(Ping{3})));
    bytes[place] = std::byte(value);
    return test::heardBy(Role::node, bytes);
}

}  // namespace

class FramesTest : public QObject {
    Q_OBJECT

  private slots:
    void aHeaderIsThirtyTwoLittleEndianBytes() {
        const auto bytes = wire::bytesOf({.version = 0x0102,
                                          .type = 0x0304,
                                          .flags = 0x05060708,
                                          .mapBytes = 0x090a0b0c,
                                          .payloadBytes = 0x0d0e0f1011121314,
                                          .checksum = 0x15161718191a1b1c});
        QCOMPARE(QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())).toHex(),
                 QByteArray("50445231"
                            "0201"
                            "0403"
                            "08070605"
                            "0c0b0a09"
                            "14131211100f0e0d"
                            "1c1b1a1918171615"));
    }

    void framesMayBeCutAnywhere() {
        for (const Role reader : {Role::node, Role::coordinator}) {
            const auto [messages, bytes] = talkTo(reader);
            for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
                FrameReader frames(reader);
                frames.setAdmitted(true);
                test::Heard heard;
                test::hear(frames, std::span(bytes).first(cut), heard);
                QVERIFY(heard.error.empty() && heard.messages.size() <= messages.size());
                test::hear(frames, std::span(bytes).subspan(cut), heard);
                QVERIFY2(heard.error.empty() && same(heard.messages, messages), heard.error.c_str());
                QVERIFY(!frames.isInside());
            }
        }
    }

    void framesMayComeByteByByte() {
        for (const Role reader : {Role::node, Role::coordinator}) {
            const auto [messages, bytes] = talkTo(reader);
            FrameReader frames(reader);
            frames.setAdmitted(true);
            test::Heard heard;
            for (const std::byte& byte : bytes)
                test::hear(frames, std::span(&byte, 1), heard);
            QVERIFY(heard.error.empty() && same(heard.messages, messages));
        }
    }

    void aFrameThatIsNotWholeIsNoMessage() {
        for (const Message& message : test::exampleMessages()) {
            const Bytes bytes = inOnePiece(encode(message));
            for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
                FrameReader frames(test::readerOf(message));
                test::Heard heard;
                test::hear(frames, std::span(bytes).first(cut), heard);
                QVERIFY(heard.messages.empty() && heard.error.empty() && frames.isInside());
            }
        }
    }

    void mapsMustEndWhereTheHeaderSays() {
        for (const Message& message : test::exampleMessages())
            for (const int more : {-1, 1}) {
                Frame frame = encode(message);
                frame.head = test::unchecked(frame.head);
                frame.head[12] = std::byte(std::to_integer<int>(frame.head[12]) + more);
                frame.head.resize(frame.head.size() + std::size_t(more));
                QVERIFY2(!test::heardBy(test::readerOf(message), inOnePiece(frame)).error.empty(),
                         (test::nameOf(message) + std::to_string(more)).c_str());
            }
    }

    void whatIsNoFrameIsRefused() {
        for (const std::size_t place : {0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 24, 31})  // magic, version, flags, checksum
            QVERIFY2(!heardPing(place, 0x55).error.empty(), qPrintable(QString::number(place)));
        for (const std::size_t place : {14, 15, 17, 18, 23})  // longer than any
            QVERIFY2(heardPing(place, 0x55).error.find("longer") != std::string::npos,
                     qPrintable(QString::number(place)));
    }

    void aFrameStatesItsChecksum() {
        // Python: zlib.crc32 of the frame with zeros in place of the checksum
        QCOMPARE(checksumOf({.type = 4, .mapBytes = 4}, std::as_bytes(std::span("\xbf\x01\x05\xff", 4)), {}),
                 0x1d45f6675u);
        for (const Message& message : test::exampleMessages()) {
            const Bytes frame = test::unchecked(inOnePiece(encode(message)));
            QVERIFY(test::heardBy(test::readerOf(message), frame).error.empty());
        }
    }

    void noFlippedBitIsTakenForAMessage() {
        for (const Message& message : test::exampleMessages()) {
            const Bytes frame = inOnePiece(encode(message));
            for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
                Bytes damaged = frame;
                damaged[bit / 8] ^= std::byte(1) << bit % 8;
                QVERIFY2(test::heardBy(test::readerOf(message), damaged).messages.empty(),
                         (test::nameOf(message) + " bit " + std::to_string(bit)).c_str());
            }
        }
    }

    void messagesOfTheWrongSideAreRefused() {
        for (const Message& message : test::exampleMessages()) {
            const Role wrong = test::readerOf(message) == Role::node ? Role::coordinator : Role::node;
            const test::Heard heard = test::heardBy(wrong, inOnePiece(encode(message)));
            QCOMPARE(heard.error.empty(), std::holds_alternative<Bye>(message));
        }
    }

    void typesOfLaterVersionsAreSkippedUnlessTheyAreCritical() {
        for (const std::uint16_t type : {0, 17, 0x7f}) {
            Bytes bytes = frameOf({.type = type, .mapBytes = 65536, .payloadBytes = 20 << 20}, 65536 + (20 << 20));
            const Bytes ping = inOnePiece(encode(Ping{3}));
            bytes.insert(bytes.end(), ping.begin(), ping.end());
            for (const std::size_t cut : {std::size_t(40), std::size_t(1 << 20), bytes.size()}) {
                FrameReader frames(Role::node);
                frames.setAdmitted(true);
                test::Heard heard;
                test::hear(frames, std::span(bytes).first(cut), heard);
                test::hear(frames, std::span(bytes).subspan(cut), heard);
                QVERIFY(heard.error.empty() && same(heard.messages, {Ping{3}}));
            }
            QVERIFY(
                !test::heardBy(Role::node, frameOf({.type = type, .payloadBytes = (20 << 20) + 1}, 0)).error.empty());
        }
        for (const std::uint16_t type : {0x80, 0xffff})
            QVERIFY(!test::heardBy(Role::node, frameOf({.type = type}, 0)).error.empty());
    }

    void strangersMustBeBrief() {
        SceneOrder order = test::exampleOrder();
        order.text.assign(70000, 'x');
        const Bytes bytes = inOnePiece(encode(order));
        QVERIFY(test::heardBy(Role::node, bytes, true).error.empty());
        QVERIFY(!test::heardBy(Role::node, std::span(bytes).first(kHeaderBytes), false).error.empty());
        for (const std::uint16_t type : {1, 100}) {
            QVERIFY(
                !test::heardBy(Role::coordinator, frameOf({.type = type, .mapBytes = 65537}, 0), false).error.empty());
            QVERIFY(
                test::heardBy(Role::coordinator, frameOf({.type = type, .mapBytes = 65536}, 0), false).error.empty());
        }
    }

    void whoIsAdmittedByAMessageMayGoOnAtLength() {
        SceneOrder order = test::exampleOrder();
        order.text.assign(70000, 'x');
        Bytes bytes = inOnePiece(encode(Welcome{}));
        const Bytes more = inOnePiece(encode(order));
        bytes.insert(bytes.end(), more.begin(), more.end());
        FrameReader frames(Role::node);
        std::span<const std::byte> rest(bytes);
        const auto welcome = frames.next(rest);
        QVERIFY(welcome && *welcome && rest.size() == more.size());
        frames.setAdmitted(true);
        const auto told = frames.next(rest);
        QVERIFY(told && *told && rest.empty());
    }

    void afterAnErrorNothingIsHeard() {
        FrameReader frames(Role::node);
        test::Heard heard;
        test::hear(frames, Bytes(kHeaderBytes), heard);
        const std::string error = std::exchange(heard.error, {});
        QVERIFY(!error.empty());
        test::hear(frames, inOnePiece(encode(Ping{})), heard);
        QVERIFY(heard.messages.empty());
        QCOMPARE(heard.error, error);
    }
};

QTEST_APPLESS_MAIN(FramesTest)
#include "frames_test.moc"
