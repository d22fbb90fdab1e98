#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/network/acted_node.h"
#include "tests/support/network/one_link.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

wire::Result resultOfNoLease() {
    wire::Result result;
    result.number = std::uint64_t(1) << 40;
    result.tile = {0, 0, 512, 512};
    result.samples = {0, 1};
    result.sums.resize(512 * 512);
    return result;
}

wire::Abandoned givenBack(const wire::Lease& lease) {
    return {lease.number, lease.nonce, ""};
}

/// A coordinator that waits for nodes, and tells why it lost them.
struct Waiting : NodeTrial {
    QSignalSpy lost{&nodes, &nodes::RenderNodes::lost};
    quint16 port = nodes.listen("127.0.0.1:0")->port;

    /// Takes samples of the scene of `revision` on a thread, from when a node has joined until it is stopped.
    std::jthread render(std::uint64_t revision) const {
        return std::jthread([this, revision](const std::stop_token& stop) {
            const auto film = *startFilm(*device, sharedScene(revision));
            while (!pool->hasWorkers() && !stop.stop_requested())
                QThread::msleep(2);
            (void)film->accumulate(1'000'000, stop);
        });
    }
    QString reason() const { return QString::fromStdString(lost.at(0).at(0).value<nodes::NodeStatus>().reason); }
};

}  // namespace

/// Nodes that say more than they were asked.
class FloodingNodesTest : public QObject {
    Q_OBJECT

  private slots:
    void floodIsCutOff_data() {
        QTest::addColumn<wire::Message>("drop");
        QTest::addColumn<int>("drops");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const wire::Message& drop, int drops, const char* reason) {
            QTest::newRow(name) << drop << drops << QString(reason);
        };
        row("answers to no Ping", wire::Pong{7}, 100'000, "more messages");
        row("introductions", wire::Hello{}, 100'000, "more messages");
        row("scenes taken", wire::SceneReady{~0u}, 100'000, "more messages");
        row("results of no lease", resultOfNoLease(), 3, "nobody asked");
        row("leases that it never had, given back", wire::Abandoned{~0u, {}, ""}, 3, "nobody asked");
    }
    void floodIsCutOff() {
        QFETCH(const wire::Message, drop);
        QFETCH(int, drops);
        QFETCH(const QString, reason);
        const FilmContent alone = imageAlone(sharedScene(), kSharedOrders);
        Waiting trial;
        NodeProcess honest;
        trial.add(honest);
        ActedNode flooder(trial.port);
        QTRY_VERIFY_WITH_TIMEOUT(flooder.isWelcome(), kPatience);
        FilmContent image;
        std::jthread renderer([&] { image = trial.image(sharedScene(), kSharedOrders, 1); });
        for (; drops > 0 && flooder.say(drop); --drops)
            QTRY_VERIFY_WITH_TIMEOUT(flooder.waits() < (1 << 20) || flooder.isOver(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(flooder.waits() == 0 || flooder.isOver(), kPatience);
        flooder.leave();
        renderer.join();
        QVERIFY(sameBits(image, alone));
        QTRY_COMPARE_WITH_TIMEOUT(trial.lost.count(), 1, kPatience);
        QVERIFY2(trial.reason().contains(reason), qPrintable(trial.reason()));
        QVERIFY(trial.workOfNodes() > 0);  // the honest one is still there
    }

    /// Waits before dialling again sum up to at least half of 0.2, 0.4, 0.8 and 1.6 s, less what timers are early; with
    /// a constant wait it would be 0.8 s.
    void floodingNodeIsDialledEverMoreSeldom() {
        Waiting trial;
        ActedNode flooder;
        QVERIFY(bool(trial.nodes.add(QString("127.0.0.1:%1").arg(flooder.port()))));
        QElapsedTimer clock;
        for (int connection = 1; connection <= 5; ++connection) {
            QTRY_VERIFY_WITH_TIMEOUT(flooder.connections() == connection && flooder.isWelcome(), kPatience);
            if (connection == 1)
                clock.start();
            flooder.say(wire::Abandoned{~0u, {}, ""});
        }
        QVERIFY2(clock.elapsed() >= 1200, qPrintable(QString::number(clock.elapsed())));
    }

    void programPartsWithACoordinatorThatFloods() {
        remote::Listener coordinator(OneLink::kCoordinator, {.channel = {.messages = {1'000'000, 1'000'000}}});
        QVERIFY(bool(coordinator.listen({"127.0.0.1", 0})));
        connect(&coordinator, &remote::Listener::connected, this, [](remote::Channel* channel) {
            connect(channel, &remote::Channel::received, channel, [channel](const wire::Message& message) {
                if (!std::holds_alternative<wire::Hello>(message))
                    return;
                channel->setAdmitted();
                channel->send(wire::Welcome{});
                for (std::uint64_t number = 0; number < 100'000; ++number)
                    channel->send(wire::Ping{number});
                channel->send(wire::Bye{});
            });
        });
        NodeProcess program({"--coordinator", QString("localhost:%1").arg(coordinator.address().port)});
        QTRY_VERIFY_WITH_TIMEOUT(program.log().contains("the connection has ended"), kPatience);
        QVERIFY2(program.log().contains("more messages"), program.log().constData());
    }

    /// The coordinator sends more leases than the node can render while they arrive.
    void programPartsWithACoordinatorThatGivesOutAllLeasesAtOnce() {
        OneLink coordinator;
        NodeProcess program({"--coordinator", QString("localhost:%1").arg(coordinator.port())});
        const auto scene = std::make_shared<const Scene>(sharedScene());
        const std::uint64_t revision = coordinator.pool->publish(Purpose::viewport, scene);
        const auto isReady = [&] {
            const std::vector<WorkerStatus> workers = coordinator.pool->workers();
            return !workers.empty() && workers[0].state == WorkerState::ready;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isReady(), kPatience);
        coordinator.channel->disconnect(coordinator.link.get());
        for (std::uint64_t number = 1; number <= 1000; ++number)
            coordinator.channel->send(wire::Lease{number, {}, revision, {0, 0, 122, 90}, {0, 64}, {}});
        QTRY_VERIFY_WITH_TIMEOUT(program.log().contains("the connection has ended"), kPatience);
        QVERIFY2(program.log().contains("more than a node can have"), program.log().constData());
    }

    void leaseIsAnsweredOnce() {
        Waiting trial;
        ActedNode node(trial.port);
        const std::jthread renderer = trial.render(1);
        const wire::Lease lease = leaseFor(node);
        node.say(givenBack(lease));
        node.say(givenBack(lease));
        node.leave();
        QTRY_COMPARE_WITH_TIMEOUT(trial.lost.count(), 1, kPatience);
        QVERIFY2(trial.reason().contains("nobody asked"), qPrintable(trial.reason()));
    }

    /// An answer to a lease of the previous scene, on its way when another scene is requested, is accepted once.
    void lateAnswerIsNoFlood() {
        Waiting trial;
        ActedNode node(trial.port);
        std::jthread renderer = trial.render(1);
        const wire::Lease before = leaseFor(node);
        renderer = {};
        renderer = trial.render(2);
        const auto isOrdered = [&node] { return node.heard<wire::SceneOrder>().size() == 2; };
        QTRY_VERIFY_WITH_TIMEOUT(isOrdered(), kPatience);
        node.say(givenBack(before));
        const wire::Lease after = leaseFor(node);
        QVERIFY(after.revision > before.revision && !node.isOver());
        node.say(givenBack(before));  // now it has taken another scene
        node.leave();
        QTRY_COMPARE_WITH_TIMEOUT(trial.lost.count(), 1, kPatience);
        QVERIFY2(trial.reason().contains("nobody asked"), qPrintable(trial.reason()));
    }

    /// While the user drags, a node gets no more scenes than it can take, and always the last one.
    void scenesThatChangeFastAreNoFlood() {
        OneLink coordinator;
        ActedNode node(coordinator.port());
        QTRY_VERIFY_WITH_TIMEOUT(node.isWelcome() && coordinator.hasJoined, kPatience);
        std::uint64_t last = 0;
        for (std::uint64_t revision = 0; revision < 100; ++revision) {
            last = coordinator.pool->publish(Purpose::viewport, std::make_shared<Scene>(sharedScene(revision)));
            coordinator.link->pump();
        }
        const auto orders = [&node] { return node.heard<wire::SceneOrder>(); };
        QTRY_VERIFY_WITH_TIMEOUT(!orders().empty() && orders().back().revision == last, kPatience);
        QCOMPARE(orders().size(), std::size_t(2));
    }

  private:
    /// Returns the lease that `node` gets after reporting that it has the newest scene.
    static wire::Lease leaseFor(ActedNode& node) {
        const auto scenes = [&node] { return node.heard<wire::SceneOrder>(); };
        const auto leases = [&node] { return node.heard<wire::Lease>(); };
        const std::size_t before = leases().size();
        const auto comes = [&node](const auto& condition) {
            if (!QTest::qWaitFor([&] { return condition() || node.isOver(); }, kPatience) || node.isOver())
                qFatal("the node gets nothing any more");
        };
        comes([&] { return !scenes().empty(); });
        node.say(wire::SceneReady{scenes().back().revision});
        comes([&] { return leases().size() > before; });
        return leases().back();
    }
};

QTEST_GUILESS_MAIN(FloodingNodesTest)
#include "flooding_nodes_test.moc"
