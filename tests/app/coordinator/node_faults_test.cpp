#include <QElapsedTimer>
#include <QTest>

#include <random>

#include "tests/support/network/fault_proxy.h"
#include "tests/support/network/one_link.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

/// What becomes of images when nodes and networks fail.
class NodeFaultsTest : public QObject {
    Q_OBJECT

    FilmContent alone_;

  private slots:
    void initTestCase() { alone_ = imageAlone(sharedScene(), kSharedOrders); }

    /// Kills one of eight nodes after the other and starts another in its place, while images are rendered.
    void killedNodesCostNoPixel() {
        NodeTrial trial;
        NodeProcesses processes = startNodes(8);
        for (const auto& one : processes)
            trial.add(*one);
        (void)trial.image(sharedScene(), {1}, 8);
        std::mt19937 random(1);
        int images = 0;
        std::atomic<bool> over = false;
        std::jthread renderer([&] {
            while (!over || images < 3) {
                if (!sameBits(trial.image(sharedScene(), kSharedOrders), alone_))
                    qFatal("a picture is another one");
                ++images;
            }
        });
        for (int kill = 0; kill < 12; ++kill) {
            QTest::qWait(500);
            auto& victim = processes[random() % processes.size()];
            victim->signal(SIGKILL);
            victim = std::make_unique<NodeProcess>();
            trial.add(*victim);
        }
        over = true;
        renderer.join();
        QVERIFY(images >= 3);
        qInfo("12 kills, %d pictures, all the same", images);
    }

    void nodesThatStandStillAreLeftOut() {
        NodeTrial trial;
        NodeProcesses processes = startNodes(2);
        for (const auto& one : processes)
            trial.add(*one);
        const auto film = *startFilm(*trial.device, sharedScene());
        trial.awaitReady(2);
        QVERIFY(film->accumulate(2, {}));
        processes[0]->signal(SIGSTOP);
        QElapsedTimer clock;
        clock.start();
        QVERIFY(film->accumulate(62, {}));
        qInfo("a node stood still: the next frame took %lld ms", clock.elapsed());
        QVERIFY(film->accumulate(64, {}));
        QVERIFY(sameBits((*film->film())->content(), alone_));
        processes[0]->signal(SIGCONT);
    }

    void theLastNodeMayGo() {
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        NodeProcesses processes = startNodes(1);
        trial.add(*processes[0]);
        const auto film = *startFilm(*trial.device, sharedScene());
        trial.awaitReady(1);
        QVERIFY(film->accumulate(2, {}));
        processes[0]->signal(SIGKILL);
        QVERIFY(film->accumulate(62, {}));
        QVERIFY(film->accumulate(64, {}));
        QVERIFY(sameBits((*film->film())->content(), alone_));
    }

    void badNetworksCostNoPixel_data() {
        QTest::addColumn<QString>("fault");
        for (const char* fault : {"delay", "pieces", "slow", "black hole", "reset", "half", "corrupt", "twice"})
            QTest::newRow(fault) << fault;
    }
    void badNetworksCostNoPixel() {
        QFETCH(const QString, fault);
        NodeTrial trial;
        const NodeProcesses processes = startNodes(2);
        FaultProxy proxy(quint16(processes[0]->address().section(':', -1).toInt()));
        QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(proxy.port()))));
        trial.add(*processes[1]);
        const auto film = *startFilm(*trial.device, sharedScene());
        trial.awaitReady(2);
        QVERIFY(film->accumulate(2, {}));
        apply(proxy, fault);
        QVERIFY(film->accumulate(62, {}));
        QVERIFY(film->accumulate(64, {}));
        QVERIFY(sameBits((*film->film())->content(), alone_));
    }

    /// The coordinator hangs while TCP still acknowledges: another coordinator may then have the node.
    void coordinatorThatIsSilentLosesItsNode() {
        NodeProcess program;
        const auto port = quint16(program.address().section(':', -1).toInt());
        remote::Dial silent({"127.0.0.1", port}, OneLink::kCoordinator);
        connect(&silent, &remote::Dial::connected, this, [](remote::Channel* channel) {
            connect(channel, &remote::Channel::received, channel, [channel](const wire::Message& message) {
                if (std::holds_alternative<wire::Hello>(message))
                    channel->send(wire::Welcome{.version = 1, .heartbeatMs = 100});
            });
        });
        QTRY_VERIFY_WITH_TIMEOUT(program.log().contains("works for"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.log().contains("not been heard of for 10 heartbeats"), kPatience);
        OneLink other;
        other.dialNode(port);
        QTRY_VERIFY_WITH_TIMEOUT(other.hasJoined, kPatience);
    }

  private:
    static void apply(FaultProxy& proxy, const QString& fault) {
        const NetworkFault bad = faultOf(fault);
        proxy.set(Direction::toClient, bad);
        if (fault == "delay" || fault == "slow" || fault == "pieces")
            proxy.set(Direction::toServer, bad);
        if (fault == "reset")
            proxy.reset();
        if (fault == "half")
            proxy.end(Direction::toClient);
    }
    static NetworkFault faultOf(const QString& fault) {
        NetworkFault bad;
        if (fault == "delay")
            bad.delay = std::chrono::milliseconds(50);
        if (fault == "slow")
            bad.bytesPerSecond = 2'000'000;
        if (fault == "pieces")
            bad.mostPiece = 7;
        bad.blackHole = fault == "black hole";
        if (fault == "corrupt")
            bad.corrupt = 20'000;
        if (fault == "twice")
            bad.duplicate = 20'000;
        return bad;
    }
};

QTEST_GUILESS_MAIN(NodeFaultsTest)
#include "node_faults_test.moc"
