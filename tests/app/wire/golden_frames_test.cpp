/// Frames as released programs send them (golden/v1, one of each type; golden/v2, those that version 2 has added;
/// golden/v2-kept, with the fields that say what a node has kept; golden/v2-checked, with checksums) are read and
/// written by this one. They are never changed: a new version of the protocol gets a folder of its own. With
/// PDR_GOLDEN_OUT, a folder, the frames of this program are written there.

#include <QDir>
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

/// `isChecked`: with its checksum.
QByteArray written(const Message& message, bool isChecked) {
    const Bytes frame = inOnePiece(encode(message)), bytes = isChecked ? frame : test::unchecked(frame);
    return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}

QByteArray golden(const QString& version, const Message& message) {
    QFile file(fileOf(PDR_SOURCE_DIR "/tests/app/wire/golden/" + version, message));
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
        if (out.isEmpty())
            return;
        for (const auto& [version, messages] : kVersions)
            for (const Message& message : messages) {
                QDir().mkpath(out + "/" + version);
                if (QFile file(fileOf(out + "/" + version, message)); file.open(QIODevice::WriteOnly))
                    file.write(written(message, version == kChecked));
            }
    }

    void framesOfEachVersionAreRead() {
        for (const auto& [version, messages] : kVersions)
            for (const Message& message : messages) {
                const QByteArray frame = golden(version, message);
                const test::Heard heard = test::heardBy(test::readerOf(message), bytesOf(frame));
                QVERIFY2(heard.messages.size() == 1 && test::same(heard.messages[0], message),
                         (test::nameOf(message) + heard.error).c_str());
            }
    }

    void framesOfEachVersionAreWritten() {
        for (const auto& [version, messages] : kVersions)
            for (const Message& message : messages) {
                const bool packed =
                    std::holds_alternative<Lease>(message) || std::holds_alternative<wire::Result>(message);
                const QByteArray now = written(message, version == kChecked), then = golden(version, message);
                QVERIFY2(packed ? mapOf(now) == mapOf(then) : now == then, test::nameOf(message).c_str());
            }
    }

  private:
    const QString kChecked = "v2-checked";
    const std::vector<std::pair<QString, std::vector<Message>>> kVersions{{"v1", test::exampleMessages()},
                                                                          {"v2", test::exampleDeepMessages()},
                                                                          {"v2-kept", test::exampleKeptMessages()},
                                                                          {kChecked, test::exampleMessages()}};
};

QTEST_APPLESS_MAIN(GoldenFramesTest)
#include "golden_frames_test.moc"
