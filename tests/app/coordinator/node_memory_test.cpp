#include <QDir>
#include <QFile>
#include <QTest>

#include <cstring>
#include <numeric>
#include <string_view>

#include "tests/support/network/process_memory.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// Voxels that stand nowhere else: a row of them is looked for in a node's memory.
constexpr int kRow = 48;

std::shared_ptr<const Volume> markedVolume() {
    return makeVolume({kRow, 40, 36}, {1, 1, 1}, [](int i, int, int) { return 1000 + (i * 7919) % 997; });
}

std::string rowBytes() {
    const auto volume = markedVolume();
    return {reinterpret_cast<const char*>(volume->voxels().data()), kRow * sizeof(std::int16_t)};
}

/// Files on disk that a process has open.
QSet<QString> filesOf(qint64 process) {
    QSet<QString> files;
    for (const QFileInfo& file : QDir(QString("/proc/%1/fd").arg(process)).entryInfoList(QDir::Files | QDir::System))
        if (!file.symLinkTarget().startsWith("/dev/") && !file.symLinkTarget().startsWith("/proc/"))  // pipes, sockets
            files << file.symLinkTarget();
    return files;
}

Scene markedScene() {
    Scene scene = plainScene(markedVolume(), 0.05f);
    scene.lookName = "ZZCANARY^123";
    return scene;
}

}  // namespace

/// What of a patient gets to a node, and what stays there.
class NodeMemoryTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        const NodeProcess process;
        if (!timesInMemoryOf(process.id(), "x"))
            QSKIP("the memory of another program cannot be read here");
    }

    void scanIsGoneAfterTheGoodbye() {
        NodeProcess process;
        std::unique_ptr<Device> device;  // outlives the connection: else its scene would be taken back before
        {
            NodeTrial trial;
            trial.add(process);
            (void)trial.image(markedScene(), {64, 64}, 1);
            QVERIFY(*timesInMemoryOf(process.id(), rowBytes()) > 0);  // else nothing was looked for
            QCOMPARE(*timesInMemoryOf(process.id(), "ZZCANARY"), 0);
            device = std::move(trial.device);
        }
        QTRY_VERIFY_WITH_TIMEOUT(process.log().contains("the connection has ended"), kPatience);
        // At once: after a minute it goes from a node whose coordinator was lost, too.
        QTRY_COMPARE_WITH_TIMEOUT(*timesInMemoryOf(process.id(), rowBytes()), 0, 30'000);
    }

    void scanIsGoneWhenItIsClosed() {
        NodeProcess process;
        NodeTrial trial;
        trial.add(process);
        (void)trial.image(markedScene(), {64}, 1);
        QVERIFY(*timesInMemoryOf(process.id(), rowBytes()) > 0);
        QVERIFY(bool(trial.device->unload()));
        QTRY_COMPARE_WITH_TIMEOUT(*timesInMemoryOf(process.id(), rowBytes()), 0, kPatience);
    }

    void logSaysNothingOfTheImage() {
        NodeProcess process;
        {
            NodeTrial trial;
            trial.add(process);
            (void)trial.image(markedScene(), {64}, 1);
        }
        process.signal(SIGTERM);
        QCOMPARE(process.code(), 0);
        QVERIFY(!process.log().contains("ZZCANARY"));
    }

    void nothingIsWritten() {
        NodeProcess process;
        NodeTrial trial;
        trial.add(process);
        (void)trial.image(markedScene(), {64}, 1);
        // What this test has open it has handed down, such as a file that takes what tests say.
        const QSet<QString> opened = filesOf(process.id()) - filesOf(QCoreApplication::applicationPid());
        QVERIFY2(opened.isEmpty(), qPrintable(opened.values().join(' ')));
    }
};

QTEST_GUILESS_MAIN(NodeMemoryTest)
#include "node_memory_test.moc"
