// First: it includes TBB, of whose names Qt takes some for keywords.
#include "render/device/gpu_device.h"
#include "tests/support/devices/faulty_gpu.h"

#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include <future>

#include "app/node/introduction.h"
#include "app/node/node_service.h"
#include "render/device/spare_device.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// A render node in this program, whose GPU fails as its plan says and whose CPU goes on then.
class NodeWithAGpu {
  public:
    NodeWithAGpu() {
        const node::OpenDevice open = [this] {
            return withSpare(
                std::make_unique<GpuDevice<FaultyGpu>>(DeviceInfo{"faulty", "a GPU", false}, plan),
                [] { return makeCpuDevice(1); }, [this](const Error& why) { service_->goOnInstead(why); });
        };
        node::NodeOptions options;
        options.listen = remote::Address{"127.0.0.1", 0};
        options.name = "gpu-07";
        options.threads = 1;
        const wire::Hello hello = *node::introduction(options, **open());
        service_ = std::make_unique<node::NodeService>(options, hello, open);
        QObject::connect(service_.get(), &node::NodeService::said, [this](const QString& line) { log += line + "\n"; });
        if (!service_->start())
            qFatal("a render node cannot listen");
    }

    QString address() const {
        static const QRegularExpression kPort("listening at \\S*:(\\d+)");
        return "localhost:" + kPort.match(log).captured(1);
    }

    const std::shared_ptr<FaultPlan> plan = std::make_shared<FaultPlan>();
    QString log;

  private:
    std::unique_ptr<node::NodeService> service_;
};

}  // namespace

/// A render node whose GPU fails.
class NodeDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    /// A node whose GPU fails before it has joined says which device renders and why, once.
    void aNodeWhoseGpuFailsAtItsReferenceTilesSaysSo() {
        const auto plan = std::make_shared<FaultPlan>();
        plan->lost = true;
        plan->fails = 40;
        std::optional<Error> instead;
        const auto device = withSpare(
            std::make_unique<GpuDevice<FaultyGpu>>(DeviceInfo{"faulty", "a GPU", false}, plan),
            [] { return makeCpuDevice(1); }, [&](const Error& why) { instead = why; });
        const auto hello = node::introduction({}, *device, instead);
        QVERIFY(hello && instead);
        QCOMPARE(hello->device, std::string("cpu"));
        QCOMPARE(hello->details, "1 thread; no GPU: it failed on purpose");
    }

    /// It goes on on its CPU, no pixel is lost, and its coordinator is told why and what renders now.
    void aNodeThatLosesItsGpuJoinsAgainAsACpu() {
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        NodeWithAGpu node;
        QVERIFY(bool(trial.nodes.add(node.address())));
        QSignalSpy joined(&trial.nodes, &nodes::RenderNodes::joined), lost(&trial.nodes, &nodes::RenderNodes::lost);
        const auto device = [&] { return trial.nodes.nodes().empty() ? "" : trial.nodes.nodes().at(0).device; };
        QTRY_COMPARE_WITH_TIMEOUT(device(), "faulty, a GPU", kPatience);
        auto image = std::async(std::launch::async, [&] {
            (void)trial.image(sharedScene(), {1}, 1);
            node.plan->lost = true;
            node.plan->fails = node.plan->calls + 3;
            return trial.image(sharedScene(1), kSharedOrders);
        });
        QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        QVERIFY(sameBits(image.get(), imageAlone(sharedScene(1), kSharedOrders)));
        QTRY_COMPARE_WITH_TIMEOUT(joined.count(), 2, kPatience);
        QCOMPARE(joined.at(1).at(0).value<nodes::NodeStatus>().device, "cpu, 1 thread; no GPU: it failed on purpose");
        QCOMPARE(lost.count(), 1);
        const auto gone = lost.at(0).at(0).value<nodes::NodeStatus>();
        QCOMPARE(gone.reason, std::string("its GPU has failed, and its CPU goes on: it failed on purpose"));
        QCOMPARE(gone.losses, 0u);
        QTRY_VERIFY_WITH_TIMEOUT(trial.nodes.nodes().at(0).state == nodes::NodeState::ready, kPatience);
    }
};

QTEST_GUILESS_MAIN(NodeDeviceTest)
#include "node_device_test.moc"
