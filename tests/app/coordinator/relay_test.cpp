/// Relays: render nodes that share their work with nodes below them.

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <future>

#include "app/node/introduction.h"
#include "app/node/node_service.h"
#include "app/node/relay.h"
#include "app/remote/certificates.h"
#include "render/device/device_list.h"
#include "tests/support/devices/lying_device.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// Part of a block, the rest of it, and several blocks.
const std::vector<std::uint32_t> kOrders{2, 62, 256};

Scene smallScene() {
    Scene scene = tissueScene();
    scene.film = {61, 45};
    return scene;
}

/// A relay and the nodes that have dialled it.
class RelayProcess : public NodeProcess {
  public:
    explicit RelayProcess(int below, const QStringList& options = {"--listen", "127.0.0.1:0"},
                          const QStringList& optionsBelow = {})
        : NodeProcess(QStringList{"--relay", "127.0.0.1:0", "--name", "relay"} + options),
          below_(QString("localhost:%1").arg(portBehind("relays to nodes at"))) {
        for (int i = 0; i < below; ++i)
            nodes.push_back(std::make_unique<NodeProcess>(dialling() + optionsBelow));
    }
    /// Options of a node that dials it.
    QStringList dialling() const { return {"--coordinator", below_}; }

  private:
    QString below_;

  public:
    NodeProcesses nodes;
};

/// A node in this program, with another device.
class InnerNode {
  public:
    InnerNode(const node::NodeOptions& options, const node::OpenDevice& open)
        : service_(options, *node::introduction(options, *makeCpuDevice(1)), open) {
        QObject::connect(&service_, &node::NodeService::said, [this](const QString& line) { log += line + "\n"; });
        if (!service_.start())
            qFatal("a render node does not start");
    }
    QString log;

  private:
    node::NodeService service_;
};

Result<std::unique_ptr<Device>> oneThread() {
    return makeCpuDevice(1);
}

/// What opens devices that lie, and are otherwise as those of `open`.
node::OpenDevice lying(const std::shared_ptr<Lies>& lies, const node::OpenDevice& open) {
    return [=] { return std::unique_ptr<Device>(std::make_unique<LyingDevice>(*open(), lies)); };
}

/// The port in a line that ends with an address.
quint16 portIn(const QString& line) {
    return quint16(line.section(':', -1).trimmed().toInt());
}

/// The port at which the relay waits for nodes from now on.
quint16 listening(node::Relay& relay, const node::NodeOptions& options) {
    quint16 port = 0;
    const auto heard = QObject::connect(&relay, &node::Relay::said, [&port](const QString& line) {
        if (line.startsWith("relays to nodes at"))
            port = portIn(line);
    });
    if (!relay.listen(options))
        qFatal("a relay does not listen");
    QObject::disconnect(heard);
    return port;
}

}  // namespace

class RelayTest : public QObject {
    Q_OBJECT

  private slots:
    void twoLevelsHaveTheBitsOfOne_data() {
        QTest::addColumn<int>("below");
        for (const int below : {0, 1, 3})
            QTest::addRow("%d nodes below", below) << below;
    }
    void twoLevelsHaveTheBitsOfOne() {
        QFETCH(const int, below);
        RelayProcess relay(below);
        QTRY_COMPARE_WITH_TIMEOUT(relay.log().count("is there"), below, kPatience);
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        trial.add(relay);
        const FilmContent alone = imageAlone(smallScene(), kOrders);
        QVERIFY(sameBits(trial.image(smallScene(), kOrders, 1), alone));
        for (const auto& node : relay.nodes)
            QTRY_VERIFY_WITH_TIMEOUT(node->log().contains("works for"), kPatience);
        relay.signal(SIGTERM);
        QCOMPARE(relay.code(), 0);
        const QRegularExpression checks("below: \\d+ tiles, .* % of their samples rendered twice; 0 wrong\n");
        QCOMPARE(QString(relay.log()).count(checks), below > 0 ? 1 : 0);
    }

    /// A relay without the nodes that it had is a node by itself, and a lost relay is a lost node.
    void lossesCostNoPixel() {
        const FilmContent alone = imageAlone(smallScene(), kOrders);
        RelayProcess relay(2);
        QTRY_COMPARE_WITH_TIMEOUT(relay.log().count("is there"), 2, kPatience);
        NodeTrial trial;
        trial.add(relay);
        (void)trial.image(smallScene(), {1}, 1);
        for (NodeProcess* process : {relay.nodes[0].get(), relay.nodes[1].get(), static_cast<NodeProcess*>(&relay)}) {
            const auto film = *startFilm(*trial.device, smallScene());
            QVERIFY(film->accumulate(2, {}));
            process->signal(SIGKILL);
            for (const std::uint32_t n : {62u, 256u})
                QVERIFY(film->accumulate(n, {}));
            QVERIFY(sameBits((*film->film())->content(), alone));
        }
    }

    void programsTakeTurns() {
        RelayProcess relay(1);
        QTRY_COMPARE_WITH_TIMEOUT(relay.log().count("is there"), 1, kPatience);
        auto first = std::make_unique<NodeTrial>();
        first->add(relay);
        (void)first->image(smallScene(), {1}, 1);
        NodeTrial second;
        second.pool->setOwnHelps(false);
        second.add(relay);
        auto image = std::async(std::launch::async, [&] { return second.image(smallScene(), kOrders, 1); });
        const auto isInLine = [&] { return second.nodes.look().at(0).state == nodes::NodeState::waiting; };
        QTRY_VERIFY_WITH_TIMEOUT(isInLine(), kPatience);
        first.reset();
        QVERIFY(sameBits(image.get(), imageAlone(smallScene(), kOrders)));
        QVERIFY(second.workOfNodes() > 0);
    }

    /// The authority of the nodes below is another one than that of the coordinator.
    void bothLevelsHaveCertificates() {
        const QTemporaryDir folder;
        const QString above = folder.filePath("above/"), below = folder.filePath("below/");
        QVERIFY(bool(remote::makeCertificates(above)) && bool(remote::makeCertificates(below)));
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        trial.nodes.setBundle(above + "coordinator");
        const auto address = trial.nodes.listen("127.0.0.1:0");
        QVERIFY2(bool(address), address ? "" : address.error().text().c_str());
        RelayProcess relay(2,
                           {"--coordinator", QString("localhost:%1").arg(address->port), "--bundle", above + "node",
                            "--relay-bundle", below + "coordinator"},
                           {"--bundle", below + "node"});
        NodeProcess stranger(relay.dialling() + QStringList{"--bundle", above + "node", "--name", "stranger"});
        QCOMPARE(stranger.code(), int(node::ExitCode::turnedAway));
        QTRY_COMPARE_WITH_TIMEOUT(relay.log().count("is there"), 2, kPatience);
        QVERIFY(sameBits(trial.image(smallScene(), kOrders, 1), imageAlone(smallScene(), kOrders)));
        for (const auto& node : relay.nodes)
            QTRY_VERIFY_WITH_TIMEOUT(node->log().contains("works for"), kPatience);
        QVERIFY2(!relay.log().contains("stranger"), relay.log());
    }

    void liarBelowIsCaughtByTheRelay_data() {
        QTest::addColumn<int>("oneIn");
        QTest::addColumn<QStringList>("options");
        QTest::newRow("at its first tile") << 1 << QStringList();
        QTest::newRow("at one in seven, where all is checked") << 7 << QStringList{"--check", "all"};
    }
    void liarBelowIsCaughtByTheRelay() {
        QFETCH(const int, oneIn);
        QFETCH(const QStringList, options);
        RelayProcess relay(0, QStringList{"--listen", "127.0.0.1:0"} + options);
        const auto lies = std::make_shared<Lies>();
        lies->oneIn = oneIn;
        node::NodeOptions below;
        below.coordinator = remote::Address{"localhost", portIn(relay.dialling().back())};
        below.name = "liar";
        const InnerNode liar(below, lying(lies, oneThread));
        QTRY_COMPARE_WITH_TIMEOUT(relay.log().count("is there"), 1, kPatience);
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        trial.add(relay);
        const FilmContent alone = imageAlone(smallScene(), kOrders);
        const auto isCaught = [&] {
            return relay.log().contains("below: liar: a tile of it was not what this machine found");
        };
        int imagesAfter = 0;
        do {  // what it does late is not used, and nobody looks at it
            imagesAfter += isCaught();
            auto image = std::async(std::launch::async, [&] { return trial.image(smallScene(), kOrders, 1); });
            QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
            QVERIFY(sameBits(image.get(), alone));
        } while (imagesAfter < 3);
        QCOMPARE(relay.log().count("a tile of it"), 1);
        QCOMPARE(trial.pool->workers().at(0).state, WorkerState::ready);
        relay.signal(SIGTERM);
        QCOMPARE(relay.code(), 0);
        QVERIFY2(QString(relay.log()).contains(QRegularExpression("rendered twice; [1-9]\\d* wrong")), relay.log());
    }

    void allThatIsRenderedBelowIsCheckedWhereThatIsWanted() {
        node::Relay relay(*referenceTiles(*makeCpuDevice(1)));
        node::NodeOptions options;
        options.relay = "127.0.0.1:0";
        options.checksAll = true;
        const quint16 port = listening(relay, options);
        const NodeProcess below({"--coordinator", QString("localhost:%1").arg(port)});
        const auto device = *relay.sharing(oneThread)();
        const double all = 320 * workOf(wholeImage(smallScene().film), {0, 1});
        do {  // a node that comes late renders a small part, all of which may be its trial
            const auto film = *startFilm(*device, smallScene());
            for (const std::uint32_t n : kOrders) {
                auto done = std::async(std::launch::async, [&] { return bool(film->accumulate(n, {})); });
                QTRY_VERIFY_WITH_TIMEOUT(done.wait_for(std::chrono::seconds(0)) == std::future_status::ready,
                                         kPatience);
                QVERIFY(done.get());
            }
        } while (relay.checks().work < 0.2 * all);
        QCOMPARE(relay.checks().share(), 1.0);
        QString said;
        QObject::connect(&relay, &node::Relay::said, [&said](const QString& line) { said = line; });
        auto* const minute = relay.findChild<QTimer*>();
        QVERIFY(minute->isActive());
        minute->setInterval(0);  // it is over
        QTRY_VERIFY_WITH_TIMEOUT(said.contains("100.0 % of their samples rendered twice; 0 wrong"), kPatience);
    }

    void relayThatLiesIsCaughtAsANodeIs() {
        node::Relay relay(*referenceTiles(*makeCpuDevice(1)));
        node::NodeOptions options;
        options.listen = remote::Address{"127.0.0.1", 0};
        options.coordinators = 1;
        options.relay = "127.0.0.1:0";
        const quint16 port = listening(relay, options);
        NodeProcess below({"--coordinator", QString("localhost:%1").arg(port)});
        const auto lies = std::make_shared<Lies>();
        const InnerNode inner(options, lying(lies, relay.sharing(oneThread)));
        QTRY_VERIFY_WITH_TIMEOUT(below.log().contains("works for"), kPatience);
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(portIn(inner.log.trimmed())))));
        auto image = std::async(std::launch::async, [&] { return trial.image(smallScene(), kOrders, 1); });
        QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        QVERIFY(sameBits(image.get(), imageAlone(smallScene(), kOrders)));
        QVERIFY(lies->told() > 0);
        const nodes::NodeStatus status = trial.nodes.look().at(0);
        QCOMPARE(status.state, nodes::NodeState::quarantined);
        QVERIFY2(status.reason.starts_with("a tile of it was not what this machine found"), status.reason.c_str());
    }
};

QTEST_GUILESS_MAIN(RelayTest)
#include "relay_test.moc"
