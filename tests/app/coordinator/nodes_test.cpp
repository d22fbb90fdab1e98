#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/node/exit_codes.h"
#include "app/remote/certificates.h"
#include "app/remote/listener.h"
#include "tests/support/network/acted_node.h"
#include "tests/support/network/shared_image.h"
#include "tests/support/scenes/part_scenes.h"

using namespace pdr;
using namespace pdr::test;
using node::ExitCode;

namespace {

const std::vector<std::uint32_t> kOrders{1, 5, 40, 64, 30, 200};

Scene scene() {
    Scene scene = tissueScene();
    scene.film = {122, 90};
    return scene;
}

}  // namespace

/// Render nodes as programs of their own.
class NodesTest : public QObject {
    Q_OBJECT

    QTemporaryDir bundle_;
    FilmContent alone_;

    QString bundle(const char* role) const { return bundle_.filePath(QString("bundle/") + role); }
    /// Returns the exit code of a node that dials a coordinator that does not exist, or that gets invalid options.
    static int codeOf(const QStringList& options) {
        NodeProcess node(options);
        return node.code();
    }

  private slots:
    void initTestCase() {
        QVERIFY(bool(remote::makeCertificates(bundle_.filePath("bundle"))));
        alone_ = imageAlone(scene(), kOrders);
    }

    void imageIsTheSameWithHoweverMany_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("bySamples");
        for (const int count : {0, 1, 2, 3, 7, 16})
            QTest::addRow("%d nodes", count) << count << false;
        QTest::newRow("3 nodes, blocks of samples") << 3 << true;
    }
    void imageIsTheSameWithHoweverMany() {
        QFETCH(const int, count);
        QFETCH(const bool, bySamples);
        NodeTrial trial;
        trial.pool->setSplit(bySamples ? Split::samples : Split::tiles);
        const NodeProcesses processes = startNodes(count);
        for (const auto& one : processes)
            trial.add(*one);
        QVERIFY(sameBits(trial.image(scene(), kOrders, count), alone_));
        QCOMPARE(trial.workOfNodes() > 0, count > 0);
    }

    void nodesDialTheCoordinatorOverTls() {
        NodeTrial trial;
        trial.nodes.setBundle(bundle("coordinator"));
        const auto address = trial.nodes.listen("127.0.0.1:0");
        QVERIFY2(bool(address), address ? "" : address.error().text().c_str());
        const QString there = QString("localhost:%1").arg(address->port);
        NodeProcess one({"--coordinator", there, "--bundle", bundle("node")}),
            other({"--coordinator", there, "--bundle", bundle("node"), "--name", "other"});
        QVERIFY(sameBits(trial.image(scene(), kOrders, 2), alone_));
        QVERIFY(trial.workOfNodes() > 0);
    }

    void coordinatorDialsNodesOverTls() {
        NodeTrial trial;
        trial.nodes.setBundle(bundle("coordinator"));
        NodeProcess one({"--listen", "127.0.0.1:0", "--bundle", bundle("node")});
        trial.add(one);
        QVERIFY(sameBits(trial.image(scene(), kOrders, 1), alone_));
    }

    void othersThanThisMachineNeedCertificates() {
        NodeTrial trial;
        QVERIFY(!trial.nodes.add("192.0.2.1"));
        QVERIFY(!trial.nodes.listen("0"));
        QVERIFY(!trial.nodes.add("not an address:x"));
        QCOMPARE(codeOf({"--coordinator", "192.0.2.1"}), int(ExitCode::configuration));
    }

    void sceneMayChange() {
        NodeTrial trial;
        const NodeProcesses processes = startNodes(2);
        for (const auto& one : processes)
            trial.add(*one);
        for (int edit = 0; edit < 6; ++edit) {
            Scene edited = scene();
            edited.camera.eyeMm.x += 10 * edit;
            edited.revision = std::uint64_t(edit);
            if (edit == 3)
                edited.volume = bumpyVolume({30, 31, 37}, {0.9, 1.1, 1.3}, 5);
            QVERIFY(sameBits(trial.image(edited, {3, 70}, edit % 2 == 0 ? 2 : 0), imageAlone(edited, {3, 70})));
        }
    }

    /// Parts of the patient are found where the window is; nodes get their labels.
    void partsAreShownByNodesToo() {
        NodeTrial trial;
        const NodeProcesses processes = startNodes(2);
        for (const auto& one : processes)
            trial.add(*one);
        Scene parted = scene();
        parted.parts.map = anyParts(*parted.volume, 3, 7);
        giveCurves(parted, 7);
        for (parted.revision = 1; parted.revision <= 3; ++parted.revision) {
            QVERIFY(bool(parted.check()));
            const FilmContent alone = imageAlone(parted, kOrders);
            QVERIFY(!sameBits(alone, alone_));
            QVERIFY(sameBits(trial.image(parted, kOrders, 2), alone));
            parted.parts.curves.front().transferFunction.nodes = {{.opacity = 0}};  // then it is hidden
            if (parted.revision == 2)
                parted.parts.map = anyParts(*parted.volume, 3, 8);  // and then these are other parts
        }
        QVERIFY(trial.workOfNodes() > 0);
    }

    void pausedNodeTakesNothing() {
        NodeTrial trial;
        NodeProcess process;
        const auto node = trial.nodes.add(process.address());
        (void)trial.image(scene(), {1}, 1);
        trial.nodes.setPaused(*node, true);
        while (trial.pool->workers().at(0).state != WorkerState::paused)
            QThread::msleep(2);
        const double before = trial.workOfNodes();
        QVERIFY(sameBits(trial.image(scene(), kOrders), alone_));
        QVERIFY(trial.workOfNodes() <= before);
    }

    void programDrainsOnSigterm() {
        NodeTrial trial;
        NodeProcess process;
        trial.add(process);
        const auto film = *startFilm(*trial.device, scene());
        trial.awaitReady(1);
        QVERIFY(film->accumulate(1, {}));
        process.signal(SIGTERM);
        for (const std::uint32_t n : {5u, 40u, 64u, 30u, 200u})
            QVERIFY(film->accumulate(n, {}));
        QCOMPARE(process.code(), int(ExitCode::done));
        QVERIFY(sameBits((*film->film())->content(), alone_));
    }

    void nodeThatIsRemovedIsForgottenAndForgets() {
        NodeTrial trial;
        NodeProcess process;
        const auto node = trial.nodes.add(process.address());
        (void)trial.image(scene(), {1}, 1);
        trial.nodes.remove(*node);
        QTRY_VERIFY_WITH_TIMEOUT(trial.nodes.nodes().empty(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(process.log().contains("the connection has ended"), kPatience);
        trial.add(process);  // and it works for the next one
        QVERIFY(sameBits(trial.image(scene(), kOrders, 1), alone_));
    }

    void whatHappensToNodesIsTold_data() {
        QTest::addColumn<int>("end");
        QTest::addColumn<quint32>("losses");
        QTest::newRow("killed") << SIGKILL << 1u;
        QTest::newRow("ends as it should, which is no fault") << SIGTERM << 0u;
    }
    void whatHappensToNodesIsTold() {
        QFETCH(const int, end);
        QFETCH(const quint32, losses);
        NodeTrial trial;
        QSignalSpy joined(&trial.nodes, &nodes::RenderNodes::joined), lost(&trial.nodes, &nodes::RenderNodes::lost);
        auto process = std::make_unique<NodeProcess>(QStringList{"--listen", "127.0.0.1:0", "--name", "alpha"});
        trial.add(*process);
        QTRY_COMPARE_WITH_TIMEOUT(joined.count(), 1, kPatience);
        const auto& known = trial.nodes.nodes();
        QTRY_VERIFY_WITH_TIMEOUT(!known.empty() && known[0].latencyMs.has_value(), kPatience);
        const nodes::NodeStatus status = trial.nodes.nodes().at(0);
        QCOMPARE(status.name, QString("alpha"));
        QCOMPARE(status.device, QString("cpu, 1 thread"));
        QVERIFY(status.bytesIn > 0 && status.bytesOut > 0);
        process->signal(end);
        QTRY_COMPARE_WITH_TIMEOUT(lost.count(), 1, kPatience);
        QCOMPARE(lost.at(0).at(0).value<nodes::NodeStatus>().losses, losses);
    }

    /// A node that lied is not dialled again: started anew, it would report a new identity.
    void nodeThatLiedIsNotDialledAgain() {
        NodeTrial trial;
        ActedNode acted;
        QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(acted.port()))));
        QTRY_VERIFY_WITH_TIMEOUT(acted.isWelcome() && !trial.pool->workers().empty(), kPatience);
        trial.pool->quarantine(trial.pool->workers().at(0).id, "it lied");
        acted.leave();
        QTRY_VERIFY_WITH_TIMEOUT(trial.pool->workers().empty(), kPatience);
        QTest::qWait(1000);  // it would be dialled within 0.2 s
        QCOMPARE(acted.connections(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(trial.nodes.nodes().at(0).state, nodes::NodeState::quarantined, kPatience);
        QCOMPARE(trial.nodes.nodes().at(0).reason, std::string("it lied"));
    }

    /// The number of its run is a node's own choice, its certificate is not.
    void nodeThatLiedIsKnownByItsCertificate() {
        const QString own = bundle_.filePath("own/");
        QVERIFY(bool(remote::makeCertificates(own, 2)));
        NodeTrial trial;
        trial.nodes.setBundle(own + "coordinator");
        const auto address = trial.nodes.listen("127.0.0.1:0");
        QVERIFY2(bool(address), address ? "" : address.error().text().c_str());
        const QString there = QString("localhost:%1").arg(address->port);
        {
            NodeProcess liar({"--coordinator", there, "--bundle", own + "node-1"});
            QTRY_COMPARE_WITH_TIMEOUT(trial.pool->workers().size(), 1u, kPatience);
            trial.pool->quarantine(trial.pool->workers().at(0).id, "it lied");
        }
        QTRY_VERIFY_WITH_TIMEOUT(trial.pool->workers().empty(), kPatience);
        NodeProcess again({"--coordinator", there, "--bundle", own + "node-1", "--name", "honest"}),
            other({"--coordinator", there, "--bundle", own + "node-2", "--name", "other"});
        QTRY_COMPARE_WITH_TIMEOUT(trial.pool->workers().size(), 2u, kPatience);
        for (const WorkerStatus& worker : trial.pool->workers())
            QCOMPARE(worker.state == WorkerState::quarantined, worker.name == "honest");
    }

    void exitCodesSayWhatToDo() {
        QCOMPARE(codeOf({}), int(ExitCode::usage));
        QCOMPARE(codeOf({"--coordinator", "localhost:x"}), int(ExitCode::usage));
        QCOMPARE(codeOf({"--coordinator", "localhost:1", "--nodes", "3"}), int(ExitCode::usage));
        QCOMPARE(codeOf({"--coordinator", "localhost:1", "--check", "all"}), int(ExitCode::usage));
        QCOMPARE(codeOf({"--coordinator", "localhost:1", "--give-up-seconds", "1"}), int(ExitCode::unreachable));
        QCOMPARE(codeOf({"--coordinator", "localhost:1", "--bundle", "/nowhere"}), int(ExitCode::configuration));
        QCOMPARE(codeOf({"--coordinator", "localhost:1", "--device", "cuda:77"}), int(ExitCode::configuration));
    }

    void coordinatorMayTurnANodeAway_data() {
        QTest::addColumn<int>("why");
        QTest::addColumn<int>("code");
        QTest::newRow("version") << int(wire::Refused::Why::version) << int(ExitCode::protocol);
        QTest::newRow("bits") << int(wire::Refused::Why::bits) << int(ExitCode::turnedAway);
    }
    void coordinatorMayTurnANodeAway() {
        QFETCH(const int, why);
        QFETCH(const int, code);
        remote::Listener listener({remote::Role::coordinator, {}});
        QVERIFY(bool(listener.listen({"127.0.0.1", 0})));
        connect(&listener, &remote::Listener::connected, this, [why](remote::Channel* channel) {
            connect(channel, &remote::Channel::received, channel, [=](const wire::Message&) {
                channel->send(wire::Refused{wire::Refused::Why(why), "no"});
                channel->close("no");
            });
        });
        NodeProcess process({"--coordinator", QString("localhost:%1").arg(listener.address().port)});
        QTRY_VERIFY_WITH_TIMEOUT(process.log().contains("has ended"), kPatience);
        QCOMPARE(process.code(), code);
    }

    void nodeOfAnotherBuildIsTurnedAway() {
        const auto pool = std::make_shared<WorkerPool>(1);
        nodes::RenderNodes others(pool, {std::byte{1}});
        NodeProcess process;
        (void)others.add(process.address());
        QTRY_VERIFY_WITH_TIMEOUT(!others.nodes().empty() && others.nodes().at(0).state == nodes::NodeState::refused,
                                 kPatience);
        QVERIFY(others.nodes().at(0).reason.find("last bits") != std::string::npos);
        QVERIFY(pool->workers().empty());
    }
};

QTEST_GUILESS_MAIN(NodesTest)
#include "nodes_test.moc"
