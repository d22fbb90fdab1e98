/// Whatever somebody sends, nothing crashes, memory stays bounded, and what is taken as a message is one. The fuzzers
/// (tests/fuzz) go further.

#include <QTest>

#include <random>

#include "tests/app/wire/frame_hand.h"
#include "tests/app/wire/watched_memory.h"
#include "tests/fuzz/heard.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

class Attacker {
  public:
    Attacker(Role reader, unsigned seed) : random_(seed) {
        for (const Message& message : test::exampleMessages())
            if (test::readerOf(message) == reader)
                frames_.push_back(test::unchecked(inOnePiece(encode(message))));
    }

    /// One to three frames, damaged in one to four places.
    Bytes next() {
        Bytes bytes;
        for (unsigned frames = below(3) + 1; frames > 0; --frames) {
            const Bytes& frame = frames_[below(frames_.size())];
            bytes.insert(bytes.end(), frame.begin(), frame.end());
        }
        for (unsigned places = below(4) + 1; places > 0 && !bytes.empty(); --places)
            damage(bytes);
        return bytes;
    }

  private:
    std::size_t below(std::size_t end) { return random_() % end; }

    void damage(Bytes& bytes) {
        static constexpr int kTelling[]{0, 1, 0x7f, 0x80, 0xff, 0x1b, 0x5b, 0x9f, 0xbf, 0xc1, 0xfb};
        const auto place = bytes.begin() + std::ptrdiff_t(below(bytes.size()));
        const auto end = place + std::ptrdiff_t(below(std::size_t(bytes.end() - place)) % 40);
        switch (below(7)) {
            case 0:
                *place = std::byte(random_());
                break;
            case 1:
                *place ^= std::byte(1) << below(8);
                break;
            case 2:
                *place = std::byte(kTelling[below(std::size(kTelling))]);
                break;
            case 3:
                bytes.erase(place, end);
                break;
            case 4:
                bytes.insert(place, std::byte(kTelling[below(std::size(kTelling))]));
                break;
            case 5:
                std::fill(place, end, std::byte(random_()));
                break;
            default:
                bytes.resize(below(bytes.size()));
        }
    }

    std::mt19937 random_;
    std::vector<Bytes> frames_;
};

Bytes headerOf(std::uint16_t type, std::uint64_t payloadBytes) {
    const auto bytes = wire::bytesOf({.type = type, .mapBytes = kMostMapBytes, .payloadBytes = payloadBytes});
    return {bytes.begin(), bytes.end()};
}

}  // namespace

class HostileFramesTest : public QObject {
    Q_OBJECT

  private slots:
    void damagedFramesDoNoHarm_data() {
        QTest::addColumn<bool>("node");
        QTest::newRow("a node") << true;
        QTest::newRow("a coordinator") << false;
    }
    void damagedFramesDoNoHarm() {
        QFETCH(bool, node);
        const Role reader = node ? Role::node : Role::coordinator;
        Attacker attacker(reader, 20);
        const std::size_t held = test::mostHeldBy([&] {
            for (int i = 0; i < 200000; ++i)
                test::hearAnything(reader, attacker.next());
        });
        qInfo("at most %.1f MiB", double(held) / (1 << 20));
        QVERIFY(held < (24 << 20));
    }

    void promisesOfStrangersCostNothing() {
        for (std::uint16_t type = 0; type < 0x90; ++type)
            for (const Role reader : {Role::node, Role::coordinator}) {
                const std::size_t held = test::mostHeldBy([&] {
                    FrameReader frames(reader);
                    const Bytes header = headerOf(type, kMostPayloadBytes);
                    std::span<const std::byte> bytes(header);
                    (void)frames.next(bytes);
                });
                QVERIFY(held < 4096);
            }
    }

    void aMessageTakesNoMoreThanItsTypeMay() {
        for (std::uint16_t type = 0; type < 0x90; ++type)
            for (const Role reader : {Role::node, Role::coordinator}) {
                const MessageKind* kind = kindOf(type);
                const std::uint64_t most = kind != nullptr ? kind->mostPayload : kMostPayloadBytes;
                const std::size_t held = test::mostHeldBy([&] {
                    FrameReader frames(reader);
                    frames.setAdmitted(true);
                    for (const Bytes& part : {headerOf(type, most), Bytes(kMostMapBytes), Bytes(1)}) {
                        std::span<const std::byte> bytes(part);
                        (void)frames.next(bytes);
                    }
                });
                QVERIFY(held < (kind != nullptr ? most : 0) + 3 * kMostMapBytes);
            }
    }
};

QTEST_APPLESS_MAIN(HostileFramesTest)
#include "hostile_frames_test.moc"
