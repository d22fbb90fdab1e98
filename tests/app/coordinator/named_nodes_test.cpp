/// What the command line says of the nodes that it was told of, and how its waiting for them ends.

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "app/remote/certificates.h"
#include "tests/support/network/acted_node.h"
#include "tests/support/network/node_process.h"
#include "tests/support/network/taken_port.h"
#include "tests/support/scenes/ball_scene.h"

using namespace pdr;
using namespace pdr::test;

class NamedNodesTest : public QObject {
    Q_OBJECT

    BallScene ball_;
    QTemporaryDir folder_;

    QStringList image(const QStringList& nodes) const {
        return QStringList{"render", ball_.scene(), "-o",  ball_.at("ball.exr"), "--size", "24x20", "--samples",
                           "64",     "--device",    "cpu", "--threads",          "1"} +
               nodes;
    }
    ProgramRun render(const QStringList& nodes) const { return BallScene::run(image(nodes)); }
    QString bundle(const char* name, const char* role) const { return folder_.filePath(QString(name) + '/' + role); }
    static qsizetype linesWith(const QByteArray& text, const QByteArray& words) {
        qsizetype lines = 0;
        for (const QByteArray& line : text.split('\n'))
            lines += line.contains(words);
        return lines;
    }

  private slots:
    void initTestCase() {
        for (const char* name : {"one", "other"})
            QVERIFY(bool(remote::makeCertificates(folder_.filePath(name))));
    }

    void nodeThatIsNotThereIsNamedInTheReport() {
        const QString nowhere = QString("127.0.0.1:%1").arg(freePort());
        const ProgramRun run = render({"--node", nowhere});
        QCOMPARE(run.code, 0);
        QVERIFY2(linesWith(run.err, "node " + nowhere.toUtf8() + ": took no part") == 1, run.err);
    }

    void waitingForANodeThatIsNotThereEnds() {
        QFile::remove(ball_.at("ball.exr"));
        const QString nowhere = QString("127.0.0.1:%1").arg(freePort());
        const ProgramRun run = render({"--node", nowhere, "--await", "1", "--await-seconds", "2"});
        QCOMPARE(run.code, 1);
        QVERIFY2(linesWith(run.err, "node " + nowhere.toUtf8() + ": there is no connection") == 1, run.err);
        QVERIFY2(run.err.contains("0 of 1 render nodes are ready after 2 s"), run.err);
        QVERIFY(!QFile::exists(ball_.at("ball.exr")));
    }

    /// The command does not wait for all of its --await-seconds.
    void waitingForANodeThatRefusesEndsAtOnce() {
        const NodeProcess node({"--listen", "127.0.0.1:0", "--bundle", bundle("one", "node")});
        const ProgramRun run = render({"--node", node.address(), "--bundle", bundle("other", "coordinator"), "--await",
                                       "1", "--await-seconds", "1000000"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains(node.address().toUtf8() + ": there is no connection: its certificate"), run.err);
        QVERIFY2(run.err.contains("only 0 of 1 render nodes can still come"), run.err);
    }

    void moreThanAreNamedCannotBeAwaited() {
        const ProgramRun run =
            render({"--node", QString("127.0.0.1:%1").arg(freePort()), "--await", "2", "--await-seconds", "1000000"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("only 1 of 2 render nodes can still come"), run.err);
    }

    void nodeIsNamedOnce() {
        const ProgramRun run = render({"--node", "127.0.0.1:4999", "--node", "127.0.0.1:4999", "--await", "2"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("named already"), run.err);
    }

    void endOfTheImageIsNoLoss() {
        const NodeProcess node({"--listen", "127.0.0.1:0", "--name", "alpha"});
        const ProgramRun run = render({"--node", node.address(), "--await", "1"});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("node alpha (cpu, 1 thread) is there"), run.err);
        QVERIFY2(linesWith(run.err, "% of the samples") == 1, run.err);
        QVERIFY2(!run.err.contains("is lost") && !run.err.contains("has left"), run.err);
    }

    void aNodeGetsNoScanForAFewSamples() {
        const NodeProcess node({"--listen", "127.0.0.1:0", "--name", "alpha"});
        const QStringList few{"--node", node.address(), "--await", "1", "--samples", "4"};
        const ProgramRun run = render(few);
        QCOMPARE(run.code, 0);
        QVERIFY2(linesWith(run.err, "this machine renders alone") == 1, run.err);
        QVERIFY2(linesWith(run.err, "took no part") + linesWith(run.err, "0.0 % of the samples, 0 tiles") == 1,
                 run.err);
        const ProgramRun byNodes = render(few + QStringList{"--nodes-only"});
        QCOMPARE(byNodes.code, 0);
        QVERIFY2(!byNodes.err.contains("this machine renders alone"), byNodes.err);
    }

    /// A refused node leaves no trace but the message about it.
    void nodeThatDialsAndIsRefusedIsNamed() {
        QProcess program;
        program.setProcessChannelMode(QProcess::MergedChannels);
        const quint16 port = freePort();
        program.start(PDR_BINARY_DIR "/bin/pdrender-cli", image({"--listen", QString("127.0.0.1:%1").arg(port),
                                                                 "--await", "1", "--await-seconds", "1000000"}));
        QByteArray said;
        const auto says = [&](const char* words) { return (said += program.readAll()).contains(words); };
        QTRY_VERIFY_WITH_TIMEOUT(says("waiting for nodes at"), kPatience);
        wire::Hello later = ActedNode::helloOfThisMachine();
        later.versions = {7, 9};
        const ActedNode acted(port, later);
        QTRY_VERIFY_WITH_TIMEOUT(says("another version of the protocol"), kPatience);
        QVERIFY2(linesWith(said, "node acted: it speaks another version") == 1, said);
        program.terminate();
        QVERIFY(program.waitForFinished(kPatience));
    }
};

QTEST_GUILESS_MAIN(NamedNodesTest)
#include "named_nodes_test.moc"
