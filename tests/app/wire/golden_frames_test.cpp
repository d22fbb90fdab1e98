/// Frames as released programs send them (golden/v1, one of each type) are read and written by this one. They are never
/// changed: a new version of the protocol gets a folder of its own. With PDR_GOLDEN_OUT, a folder, the frames of this
/// program are written there.

#include <QFile>
#include <QTest>

#include "tests/app/wire/frame_hand.h"
#include "tests/support/places.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

QString fileOf(const QString& folder, const Message& message) {
    return folder + "/" + QString::fromStdString(test::nameOf(message)) + ".bin";
}

QByteArray written(const Message& message) {
    const Bytes bytes = inOnePiece(encode(message));
    return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}

QByteArray golden(const Message& message) {
    QFile file(fileOf(PDR_SOURCE_DIR "/tests/app/wire/golden/v1", message));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::span<const std::byte> bytesOf(const QByteArray& bytes) {
    return std::as_bytes(std::span(bytes.constData(), std::size_t(bytes.size())));
}

/// The map; what zstd packs may differ from version to version of it.
QByteArray mapOf(const QByteArray& frame) {
    const auto header = headerOf(Role::node, bytesOf(frame).first<kHeaderBytes>());
    const auto other = headerOf(Role::coordinator, bytesOf(frame).first<kHeaderBytes>());
    return frame.mid(kHeaderBytes, header ? header->mapBytes : other->mapBytes);
}

}  // namespace

class GoldenFramesTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        const QString out = qEnvironmentVariable("PDR_GOLDEN_OUT");
        for (const Message& message : test::exampleMessages())
            if (QFile file(fileOf(out, message)); !out.isEmpty() && file.open(QIODevice::WriteOnly))
                file.write(written(message));
    }

    void framesOfVersionOneAreRead() {
        for (const Message& message : test::exampleMessages()) {
            const QByteArray frame = golden(message);
            const test::Heard heard = test::heardBy(test::readerOf(message), bytesOf(frame));
            QVERIFY2(heard.messages.size() == 1 && test::same(heard.messages[0], message),
                     (test::nameOf(message) + heard.error).c_str());
        }
    }

    void framesOfVersionOneAreWritten() {
        for (const Message& message : test::exampleMessages()) {
            const bool packed = std::holds_alternative<Lease>(message) || std::holds_alternative<wire::Result>(message);
            const QByteArray now = written(message), then = golden(message);
            QVERIFY2(packed ? mapOf(now) == mapOf(then) : now == then, test::nameOf(message).c_str());
        }
    }
};

QTEST_APPLESS_MAIN(GoldenFramesTest)
#include "golden_frames_test.moc"
