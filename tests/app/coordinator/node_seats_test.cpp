/// What a node keeps apart for the coordinators that share it: contents and memory.

#include <QRegularExpression>
#include <QTest>

#include <atomic>
#include <future>

#include "app/node/introduction.h"
#include "app/node/node_service.h"
#include "tests/support/network/acted_coordinator.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// A render node in this program, with as much memory as a test says.
class NodeWithMemory {
  public:
    explicit NodeWithMemory(int coordinators = 4) {
        const node::OpenDevice open = [] { return makeCpuDevice(1); };
        node::NodeOptions options;
        options.listen = remote::Address{"127.0.0.1", 0};
        options.coordinators = coordinators;
        const wire::Hello hello = *node::introduction(options, **open());
        service_ = std::make_unique<node::NodeService>(
            options, hello, open, [this] { return bytes.load(); }, [this] { return std::chrono::seconds(now.load()); });
        QObject::connect(service_.get(), &node::NodeService::said, [this](const QString& line) { log += line + "\n"; });
        if (!service_->start())
            qFatal("a render node cannot listen");
    }
    quint16 port() const {
        static const QRegularExpression kPort("listening at \\S*:(\\d+)");
        return quint16(kPort.match(log).captured(1).toInt());
    }

    std::atomic<std::uint64_t> bytes = std::uint64_t(1) << 40;
    std::atomic<int> now = 1000;  ///< seconds
    QString log;

  private:
    std::unique_ptr<node::NodeService> service_;
};

constexpr std::uint64_t kVoxelBytes = 2 * 64 * 64 * 64;
/// Memory for one scene, and too little for two.
constexpr auto kForOne = std::uint64_t(1.5 * node::NodeContents::kSceneOverhead * kVoxelBytes);

Scene largeScene(int seed) {
    return plainScene(bumpyVolume(ivec3(64), dvec3(1), seed), 0.05f);
}

/// Whether the node has asked the coordinator for a content, or can do without.
bool hasAnswer(const ActedCoordinator& coordinator) {
    return !coordinator.heard<wire::Need>().empty() || !coordinator.heard<wire::SceneReady>().empty();
}

bool isRefusedForOthers(const ActedCoordinator& coordinator) {
    const auto refused = coordinator.heard<wire::SceneRefused>();
    return !refused.empty() && !refused.back().place &&
           refused.back().reason.find("since others use this render node, too") != std::string::npos;
}

}  // namespace

class NodeSeatsTest : public QObject {
    Q_OBJECT

  private slots:
    /// A coordinator that knows the name of a content, from whomever, is not given it but asked for it.
    void contentsAreNotShared_data() {
        QTest::addColumn<int>("key");
        QTest::newRow("a key of its own") << 2;
        QTest::newRow("the other's key, too") << 1;
    }
    void contentsAreNotShared() {
        QFETCH(const int, key);
        NodeWithMemory node;
        ActedCoordinator owner(node.port(), std::byte{1}), other(node.port(), std::byte(key));
        QTRY_VERIFY_WITH_TIMEOUT(owner.hasNode() && other.hasNode(), kPatience);
        const nodes::OutgoingScene going = owner.order(1, largeScene(3));
        owner.send(going.contents.at(0));
        QTRY_COMPARE_WITH_TIMEOUT(owner.heard<wire::SceneReady>().size(), 1u, kPatience);
        other.order(1, largeScene(3), std::byte{1});
        QTRY_VERIFY_WITH_TIMEOUT(hasAnswer(other), kPatience);
        QVERIFY(other.heard<wire::SceneReady>().empty());
        QVERIFY(other.heard<wire::Need>().at(0).content == going.contents.at(0).hash);
    }

    /// Memory is promised before it is taken: the first one's voxels have not been sent yet.
    void promisedMemoryIsNotPromisedAgain() {
        NodeWithMemory node;
        node.bytes = kForOne;
        ActedCoordinator first(node.port()), second(node.port(), std::byte{2});
        QTRY_VERIFY_WITH_TIMEOUT(first.hasNode() && second.hasNode(), kPatience);
        const nodes::OutgoingScene going = first.order(1, largeScene(3));
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::Need>().size(), 1u, kPatience);
        second.order(1, largeScene(4));
        QTRY_VERIFY_WITH_TIMEOUT(isRefusedForOthers(second) || hasAnswer(second), kPatience);
        QVERIFY(!hasAnswer(second));
        // It turns out that there is enough for both
        node.bytes = 2 * kForOne;
        first.send(going.contents.at(0));
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::SceneReady>().size(), 1u, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(second.heard<wire::Need>().size(), 1u, kPatience);
        QCOMPARE(second.heard<wire::SceneRefused>().size(), 1u);  // it was told once
    }

    /// A scene that did not fit beside others is taken when they have gone, and the coordinator does nothing for that.
    void sceneIsTakenWhenTheOthersHaveGone() {
        NodeWithMemory node;
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        const Scene scene = largeScene(5);
        {
            ActedCoordinator first(node.port());
            QTRY_VERIFY_WITH_TIMEOUT(first.hasNode(), kPatience);
            const nodes::OutgoingScene going = first.order(1, largeScene(3));
            first.send(going.contents.at(0));
            QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::SceneReady>().size(), 1u, kPatience);
            node.bytes = kVoxelBytes;
            QVERIFY(bool(trial.nodes.add(QString("localhost:%1").arg(node.port()))));
            QVERIFY(bool(trial.device->upload(scene)));
            const auto reason = [&] { return trial.nodes.nodes().empty() ? "" : trial.nodes.nodes()[0].reason; };
            QTRY_VERIFY_WITH_TIMEOUT(reason().find("others use this render node") != std::string::npos, kPatience);
            node.bytes = 4 * kForOne;
            first.say(wire::Bye{});
            QTRY_VERIFY_WITH_TIMEOUT(reason().empty(), kPatience);
        }
        const auto isReady = [&] { return trial.pool->workers().at(0).state == WorkerState::ready; };
        QTRY_VERIFY_WITH_TIMEOUT(isReady(), kPatience);
        QVERIFY(trial.nodes.nodes()[0].reason.empty());
        auto image = std::async(std::launch::async, [&] { return trial.image(scene, {64}); });
        QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        QVERIFY(sameBits(image.get(), imageAlone(scene, {64})));
    }

    /// A coordinator that loses its connection finds its scan where it was.
    void lostScanIsFoundByItsOwner() {
        NodeWithMemory node;
        loseScan(node);
        ActedCoordinator again(node.port());
        QTRY_VERIFY_WITH_TIMEOUT(again.hasNode(), kPatience);
        again.order(2, largeScene(3));
        QTRY_COMPARE_WITH_TIMEOUT(again.heard<wire::SceneReady>().size(), 1u, kPatience);
        QVERIFY(again.heard<wire::Need>().empty());
    }

    void lostScanIsNotFoundByOthers() {
        NodeWithMemory node;
        loseScan(node);
        ActedCoordinator other(node.port(), std::byte{2});
        QTRY_VERIFY_WITH_TIMEOUT(other.hasNode(), kPatience);
        other.order(2, largeScene(3), std::byte{1});
        QTRY_VERIFY_WITH_TIMEOUT(hasAnswer(other), kPatience);
        QVERIFY(other.heard<wire::SceneReady>().empty());
    }

    void theLineMoves() {
        NodeWithMemory node(1);
        ActedCoordinator first(node.port()), second(node.port(), std::byte{2});
        QTRY_VERIFY_WITH_TIMEOUT(first.hasNode() && second.hasNode(), kPatience);
        first.order(1, largeScene(3));
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::Need>().size(), 1u, kPatience);
        second.order(1, largeScene(4));
        QTRY_COMPARE_WITH_TIMEOUT(second.heard<wire::SceneRefused>().size(), 1u, kPatience);
        QCOMPARE(second.heard<wire::SceneRefused>()[0].place, std::optional(1u));
        first.say(wire::Forget{});
        QTRY_COMPARE_WITH_TIMEOUT(second.heard<wire::Need>().size(), 1u, kPatience);
    }

    /// Whoever renders nothing gives its seat to those who would, and is told its place in the line.
    void anIdleSeatGoesToWhoWaits() {
        NodeWithMemory node(1);
        ActedCoordinator first(node.port()), second(node.port(), std::byte{2});
        QTRY_VERIFY_WITH_TIMEOUT(first.hasNode() && second.hasNode(), kPatience);
        first.send(first.order(1, largeScene(3)).contents.at(0));
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::SceneReady>().size(), 1u, kPatience);
        // A lease is work
        node.now += 50;
        wire::Lease lease;
        lease.revision = 1;
        lease.tile = {0, 0, 16, 16};
        lease.samples = {0, 1};
        first.say(lease);
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::Result>().size(), 1u, kPatience);
        node.now += 50;
        const auto refused = [](const ActedCoordinator& one) { return one.heard<wire::SceneRefused>(); };
        second.order(1, largeScene(4));
        QTRY_COMPARE_WITH_TIMEOUT(refused(second).size(), 1u, kPatience);
        // Then it has none
        node.now += 50;
        second.order(2, largeScene(4));
        QTRY_COMPARE_WITH_TIMEOUT(second.heard<wire::Need>().size(), 1u, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(refused(first).size(), 1u, kPatience);
        QVERIFY(refused(first)[0].revision == 1u && refused(first)[0].place == 1u);
        // It comes back when it orders a scene, or nobody needs the seat
        second.say(wire::Forget{});
        QTRY_COMPARE_WITH_TIMEOUT(first.heard<wire::Need>().size(), 2u, kPatience);
    }

    void whoHasLostItsSeatWaitsBehindThoseWithWork() {
        NodeWithMemory node(1);
        ActedCoordinator idle(node.port()), second(node.port(), std::byte{2}), third(node.port(), std::byte{3});
        QTRY_VERIFY_WITH_TIMEOUT(idle.hasNode() && second.hasNode() && third.hasNode(), kPatience);
        idle.order(1, largeScene(3));
        QTRY_COMPARE_WITH_TIMEOUT(idle.heard<wire::Need>().size(), 1u, kPatience);
        node.now += 61;
        second.order(1, largeScene(4));
        QTRY_COMPARE_WITH_TIMEOUT(second.heard<wire::Need>().size(), 1u, kPatience);
        third.order(1, largeScene(5));
        const auto place = [](const ActedCoordinator& one) {
            const auto refused = one.heard<wire::SceneRefused>();
            return refused.empty() ? std::nullopt : refused.back().place;
        };
        QTRY_VERIFY_WITH_TIMEOUT(place(third) == 1u && place(idle) == 2u, kPatience);
        idle.order(2, largeScene(3));
        QTRY_VERIFY_WITH_TIMEOUT(idle.heard<wire::SceneRefused>().back().revision == 2u, kPatience);
        QVERIFY(place(idle) == 2u);
        node.now += 61;
        idle.order(3, largeScene(3));  // of two with work, who has waited longer is next
        QTRY_COMPARE_WITH_TIMEOUT(third.heard<wire::Need>().size(), 1u, kPatience);
        QVERIFY(idle.heard<wire::Need>().size() == 1u);
    }

  private:
    /// Lets a coordinator with the first key leave its scan there without a goodbye.
    static void loseScan(const NodeWithMemory& node) {
        {
            ActedCoordinator owner(node.port());
            QTRY_VERIFY_WITH_TIMEOUT(owner.hasNode(), kPatience);
            const nodes::OutgoingScene going = owner.order(1, largeScene(3));
            owner.send(going.contents.at(0));
            QTRY_COMPARE_WITH_TIMEOUT(owner.heard<wire::SceneReady>().size(), 1u, kPatience);
        }
        QTRY_VERIFY_WITH_TIMEOUT(node.log.contains("the connection has ended"), kPatience);
    }
};

QTEST_GUILESS_MAIN(NodeSeatsTest)
#include "node_seats_test.moc"
