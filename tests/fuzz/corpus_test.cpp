/// The seeds of the fuzzers and the golden frames, as they are and cut anywhere, heard by both sides (heard.h).

#include <QDirIterator>
#include <QFile>
#include <QTest>

#include "tests/fuzz/packed.h"
#include "tests/support/places.h"

using namespace pdr;

class CorpusTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingInTheCorpusDoesHarm() {
        int files = 0;
        for (const char* folder : {"/tests/fuzz/corpus", "/tests/app/wire/golden/v1"})
            for (QDirIterator each(PDR_SOURCE_DIR + QString(folder), QDir::Files); each.hasNext(); ++files) {
                QFile file(each.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QByteArray content = file.readAll();
                const auto bytes = std::as_bytes(std::span(content.constData(), std::size_t(content.size())));
                for (std::size_t end = 0; end <= bytes.size(); ++end)
                    for (const wire::Role role : {wire::Role::node, wire::Role::coordinator})
                        test::hearAnything(role, bytes.first(end));
            }
        QVERIFY(files > 30);
    }

    /// Each count of pixels and of own ones beside a limit, with bits all set, none, and every other.
    void packedSumsOfAnySizeDoNoHarm() {
        for (const int pixels : {0, 1, 8, 9, 256, 2047, 2048, 2049})
            for (const int own : {0, 1, pixels - 1, pixels, pixels + 1, 4096, 65535})
                for (const int slices : {0, 1})
                    for (const int fill : {0, 0xff, 0xaa}) {
                        const std::array<int, 6> seed{pixels & 255,   pixels >> 8, own & 255,
                                                      own >> 8 & 255, slices,      fill};
                        std::array<std::byte, 6> bytes;
                        std::ranges::transform(seed, bytes.begin(), [](int one) { return std::byte(one); });
                        test::unpackAnySums(bytes);
                    }
    }

    /// A sound frame reaches its reader through zstd; one that is wrong behind zstd is refused there.
    void framesAreReadBehindZstd() {
        const unsigned wrongs[]{0,           test::kOtherOwn, test::kOtherPixels, test::kShort,
                                test::kLong, test::kTail,     test::kSliceTooMany};
        for (int kind = 1; kind < 5; ++kind)
            for (const unsigned wrong : wrongs)
                for (const int side : {0, 7, 8})
                    QCOMPARE(isHeard({kind, int(wrong), side, side, 0, 200, 0xaa, 0x3f}), wrong == 0);
    }

  private:
    static bool isHeard(std::initializer_list<int> seed) {
        wire::Bytes bytes;
        for (const int one : seed)
            bytes.push_back(std::byte(one));
        const test::MadeFrame frame = test::packedFrameOf(bytes);
        wire::FrameReader frames(frame.reader);
        frames.setAdmitted(true);
        std::span<const std::byte> rest(frame.bytes);
        const auto message = frames.next(rest);
        return message && *message;
    }
};

QTEST_APPLESS_MAIN(CorpusTest)
#include "corpus_test.moc"
