// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/ptx/runtime/runtime.h"
#include "tests/ptx/small_scenes.h"

#include <QRegularExpression>
#include <QTest>

#include <future>

#include "app/node/introduction.h"
#include "app/node/node_service.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

Scene smallScene(std::uint64_t revision) {
    Scene scene = sceneOf(kSurface);
    scene.film = {40, 24};
    scene.revision = revision;
    return scene;
}

/// Lets no call of the CUDA runtime succeed any more.
void loseTheGpu() {
    ptx::Runtime::get().call("test", [](ptx::Runtime&) { return cudaErrorLaunchFailure; });
}

}  // namespace

/// A render node with the CUDA device.
class NodeTest : public QObject {
    Q_OBJECT

  private slots:
    void aNodeWhoseGpuIsLostGoesOnAsACpu() {
        // Start the node as its program does
        node::NodeService* running = nullptr;
        const node::OpenDevice open = [&] {
            return openDeviceToTheEnd("auto", 1, [&](const Error& why) { running->goOnInstead(why); });
        };
        node::NodeOptions options;
        options.listen = remote::Address{"127.0.0.1", 0};
        options.name = "gpu-07";
        options.threads = 1;
        const auto hello = node::introduction(options, **open());
        QVERIFY(hello && hello->device == "cuda");
        node::NodeService service(options, *hello, open);
        running = &service;
        QString log;
        connect(&service, &node::NodeService::said, this, [&](const QString& line) { log += line + "\n"; });
        QVERIFY(bool(service.start()));
        // Its bits are the CPU's, so that it is welcome
        static const QRegularExpression kPort("listening at \\S*:(\\d+)");
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        QVERIFY(bool(trial.nodes.add("localhost:" + kPort.match(log).captured(1))));
        const auto shown = [&] { return trial.nodes.nodes().empty() ? "" : trial.nodes.nodes().at(0).device; };
        QTRY_VERIFY_WITH_TIMEOUT(shown().startsWith("cuda, PTX on the CPU"), kPatience);
        // Lose the GPU between two images
        auto image = std::async(std::launch::async, [&] {
            const bool isRight = sameBits(trial.image(smallScene(1), {1}, 1), imageAlone(smallScene(1), {1}));
            loseTheGpu();
            return isRight && sameBits(trial.image(smallScene(2), {2, 30}), imageAlone(smallScene(2), {2, 30}));
        });
        QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        QVERIFY(image.get());
        QTRY_VERIFY_WITH_TIMEOUT(shown().startsWith("cpu, 1 thread; no GPU: the GPU was lost ("), kPatience);
    }
};

QTEST_GUILESS_MAIN(NodeTest)
#include "node_test.moc"
