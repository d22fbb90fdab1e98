/// What a node keeps of its results, so that it need not be sent back.

#include <QTest>

#include <future>

#include "app/node/kept_sums.h"
#include "render/tiles/shared_request.h"
#include "render/tiles/trace_lease.h"
#include "tests/support/network/acted_coordinator.h"
#include "tests/support/network/shared_image.h"

using namespace pdr;
using namespace pdr::test;

namespace {

wire::Lease leaseOf(std::uint64_t number, SampleRange samples) {
    wire::Lease lease;
    lease.number = number;
    lease.revision = 1;
    lease.tile = {0, 0, 32, 16};
    lease.samples = samples;
    return lease;
}

/// Whether both leases continue the same.
bool isSame(const Lease& a, const Lease& b) {
    return sameBits(std::span(a.before), b.before) && sameBits(std::span(a.moments), b.moments);
}

}  // namespace

class KeptSumsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Tiles of each order are of another size, so that cells come from several results.
    void whatANodeKeepsIsWhatItWouldBeSent() {
        Scene scene = sharedScene(1);
        scene.film = {58, 40};
        const auto device = makeCpuDevice(1);
        QVERIFY(bool(device->upload(scene)));
        Film film(scene.film, 0);
        KeptCells known;
        node::KeptSums kept;
        constexpr WorkerId kNode = 1;
        std::uint64_t number = 1;
        int continued = 0, all = 0;
        double cost = 600;
        for (const std::uint64_t goal : {1, 4, 30, 64, 128, 320, 330, 384, 640}) {
            SharedRequest request(film, 1, {{film.area(), film.samplesPerPixel(), goal}}, Split::tiles, number,
                                  CellCosts());
            while (const auto portion = request.scheduler().take(kNode, {cost, 1e6, 1e9}, 0)) {
                const Lease lease = request.leaseOf(*portion);
                if (known.has(kNode, portion->tile, portion->samples)) {
                    Lease filled{lease.number, lease.scene, lease.tile, lease.samples, {}, {}};
                    QVERIFY(kept.fill(filled));
                    QVERIFY(isSame(filled, lease));
                    ++continued;
                }
                all += !lease.before.empty() || !lease.moments.empty();
                LeaseResult result = *traceLease(*device, lease, {});
                kept.keep(result);
                known.took(kNode, portion->tile, portion->samples);
                QVERIFY(bool(request.take(std::move(result))));
            }
            number = request.scheduler().nextNumber();
            cost *= 2.5;
        }
        QVERIFY(all > 30);
        QCOMPARE(continued, all);
    }

    void aNodeGoesOnWithWhatItHasKept() {
        NodeProcess node;
        ActedCoordinator coordinator(quint16(node.address().section(':', -1).toInt()));
        QTRY_VERIFY_WITH_TIMEOUT(coordinator.hasNode(), kPatience);
        QVERIFY(coordinator.heard<wire::Hello>().at(0).keptPixels > 0u);
        for (const nodes::Content& content : coordinator.order(1, sharedScene(1)).contents)
            coordinator.send(content);
        QTRY_VERIFY_WITH_TIMEOUT(!coordinator.heard<wire::SceneReady>().empty(), kPatience);
        coordinator.say(leaseOf(1, {0, 2}));
        const auto results = [&] { return coordinator.heard<wire::Result>(); };
        QTRY_COMPARE_WITH_TIMEOUT(results().size(), std::size_t(1), kPatience);
        const wire::Result first = results()[0];
        // Once with the sums, once without
        wire::Lease next = leaseOf(2, {2, 3});
        next.before = first.sums;
        coordinator.say(next);
        QTRY_COMPARE_WITH_TIMEOUT(results().size(), std::size_t(2), kPatience);
        coordinator.say(leaseOf(3, {0, 2}));
        QTRY_COMPARE_WITH_TIMEOUT(results().size(), std::size_t(3), kPatience);
        wire::Lease short_ = leaseOf(4, {2, 3});
        short_.kept = wire::sumsHash(std::array<std::byte, 32>{std::byte{1}}, first.sums, {});
        coordinator.say(short_);
        QTRY_COMPARE_WITH_TIMEOUT(results().size(), std::size_t(4), kPatience);
        QVERIFY(sameBits(std::span<const PixelSums>(results()[3].sums), results()[1].sums));
        // Other sums than it has, and sums that it has not any more
        short_.number = 5;
        short_.samples = {5, 3};
        coordinator.say(short_);
        const auto givenBack = [&] { return coordinator.heard<wire::Abandoned>().size(); };
        QTRY_COMPARE_WITH_TIMEOUT(givenBack(), std::size_t(1), kPatience);
        coordinator.say(wire::Lease{6, {}, 1, {16, 16, 16, 16}, {2, 3}, {}, {}, short_.kept});
        QTRY_COMPARE_WITH_TIMEOUT(givenBack(), std::size_t(2), kPatience);
        QCOMPARE(results().size(), std::size_t(4));
        QVERIFY(coordinator.heard<wire::Abandoned>()[0].reason.empty());
    }

    void sumsAreNotSentBackToTheNodeThatHasThem() {
        const std::vector<std::uint32_t> orders{1, 3, 12, 48};
        NodeProcess node;
        NodeTrial trial;
        trial.pool->setOwnHelps(false);
        trial.add(node);
        auto first = std::async(std::launch::async, [&] { return trial.image(sharedScene(), {64, 64}, 1); });
        QTRY_VERIFY_WITH_TIMEOUT(first.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        const qint64 before = trial.nodes.look()[0].bytesOut, sumsIn = trial.nodes.look()[0].bytesIn;
        auto image = std::async(std::launch::async, [&] { return trial.image(sharedScene(1), orders, 1); });
        QTRY_VERIFY_WITH_TIMEOUT(image.wait_for(std::chrono::seconds(0)) == std::future_status::ready, kPatience);
        QVERIFY(sameBits(image.get(), imageAlone(sharedScene(1), orders)));
        const nodes::NodeStatus after = trial.nodes.look()[0];
        QVERIFY(trial.workOfNodes() > 0);
        const double way = double(after.bytesOut - before), back = double(after.bytesIn - sumsIn);
        QVERIFY2(way < 0.4 * back, qPrintable(QString("%1 and %2 bytes").arg(way).arg(back)));
    }
};

QTEST_GUILESS_MAIN(KeptSumsTest)
#include "kept_sums_test.moc"
