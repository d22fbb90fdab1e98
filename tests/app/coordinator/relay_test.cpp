/// Relays: render nodes that share their work with nodes below them.

#include <QTest>

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
    explicit RelayProcess(int below)
        : NodeProcess({"--listen", "127.0.0.1:0", "--relay", "127.0.0.1:0", "--name", "relay"}) {
        static const QRegularExpression kPort("relays to nodes at \\S*:(\\d+)");
        const QString port = kPort.match(QString::fromUtf8(log())).captured(1);
        for (int i = 0; i < below; ++i)
            nodes.push_back(std::make_unique<NodeProcess>(QStringList{"--coordinator", "localhost:" + port}));
    }
    NodeProcesses nodes;
};

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
            QVERIFY(node->log().contains("works for"));
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
};

QTEST_GUILESS_MAIN(RelayTest)
#include "relay_test.moc"
