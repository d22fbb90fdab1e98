// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/tissue_scene.h"

#include <QTest>

#include "render/device/device_list.h"
#include "render/device/gpu_device.h"
#include "render/device/spare_device.h"
#include "render/session/batch_render.h"
#include "render/tiles/reference_tiles.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/faulty_gpu.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr std::uint64_t kSamples = 40;

/// Records the reasons why the other device takes over.
struct Told {
    std::vector<Error> all;
    WhySpare hear() {
        return [this](const Error& why) { all.push_back(why); };
    }
};

Result<std::unique_ptr<Device>> cpu() {
    return makeCpuDevice(1);
}

Result<FilmContent> imageBy(Device& device) {
    const auto film = startFilm(device, tissueScene());
    if (!film)
        return film.error();
    const auto ended = BatchRender(**film, {.samples = kSamples}, {}).run({}, [](const BatchState&) {});
    if (!ended)
        return ended.error();
    const auto image = (*film)->film();
    if (!image)
        return image.error();
    return (*image)->content();
}

FilmContent alone() {
    return *imageBy(**cpu());
}

}  // namespace

/// Tests "auto" with a GPU that cannot do its work, and the CPU that takes over.
class SpareDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    void deviceThatFailsHandsOver_data() {
        QTest::addColumn<int>("uploads");
        QTest::addColumn<int>("launches");
        QTest::addColumn<bool>("tooSmall");
        QTest::newRow("too old: it fails at its first upload") << 0 << Mishaps::kNever << false;
        QTest::newRow("its memory is taken") << Mishaps::kNever << Mishaps::kNever << true;
        QTest::newRow("its first launch fails") << Mishaps::kNever << 0 << false;
        QTest::newRow("it is lost on the way") << Mishaps::kNever << 1 << false;
    }
    void deviceThatFailsHandsOver() {
        QFETCH(const int, uploads);
        QFETCH(const int, launches);
        QFETCH(const bool, tooSmall);
        const auto mishaps = std::make_shared<Mishaps>();
        mishaps->uploads = uploads;
        mishaps->accumulates = launches;
        mishaps->tooSmall = tooSmall;
        Told told;
        const auto device = withSpare(failing(mishaps), cpu, told.hear());
        const auto image = imageBy(*device);
        QVERIFY2(bool(image), image ? "" : image.error().text().c_str());
        QVERIFY(sameBits(*image, alone()));
        QCOMPARE(told.all.size(), std::size_t(1));
        QVERIFY(told.all[0].what.find(tooSmall ? "9.3 GB" : "the device is lost") != std::string::npos);
        QCOMPARE(device->info().name, std::string("cpu"));
    }

    /// A failure of each call and of all after it gives the right image, or none and an error text.
    void gpuThatIsLostAtAnyCallGivesTheRightImageOrNone() {
        const FilmContent right = alone();
        int handedOver = 0, none = 0;
        for (int call = 0;; call += call < 50 ? 1 : 97) {
            const auto plan = std::make_shared<FaultPlan>();
            plan->fails = call;
            plan->lost = true;
            Told told;
            const auto device = withSpare(std::make_unique<GpuDevice<FaultyGpu>>(DeviceInfo{"faulty", "", false}, plan),
                                          cpu, told.hear());
            const auto image = imageBy(*device);
            if (!plan->failed)
                break;
            QVERIFY(told.all.size() <= 1);
            if (image) {
                QVERIFY(sameBits(*image, right));
                handedOver += int(told.all.size());
            } else {
                QCOMPARE(image.error().kind, ErrorKind::deviceLost);
                ++none;
            }
            QVERIFY(image || told.all.empty());
        }
        qInfo("the CPU took over %d times, %d times there was no picture", handedOver, none);
        QVERIFY(handedOver > 30);
    }

    /// Only another device needs a spare one: the CPU's memory is this program's.
    void theCpuStandsInForOthersOnly() {
        const auto mishaps = std::make_shared<Mishaps>();
        mishaps->accumulates = 1;
        Told told;
        const auto device = withCpuAsSpare(failing(mishaps), 1, told.hear());
        const auto image = imageBy(*device);
        QVERIFY(image && sameBits(*image, alone()));
        QCOMPARE(told.all.size(), std::size_t(1));
        auto cpu = makeCpuDevice(1);
        const Device* same = cpu.get();
        QVERIFY(withCpuAsSpare(std::move(cpu), 1, told.hear()).get() == same);
    }

    void deviceThatWorksIsKept() {
        Told told;
        const auto device = withSpare(failing(std::make_shared<Mishaps>()), cpu, told.hear());
        const auto image = imageBy(*device);
        QVERIFY(image && sameBits(*image, alone()));
        QVERIFY(told.all.empty());
        QCOMPARE(device->info().name, std::string("failing"));
    }

    /// The samples of a render node: its GPU may be lost in any of them.
    void samplesForOthersGoOnFromTheirSums() {
        const auto right = *referenceTiles(**cpu());
        int tookOver = 0;
        for (int call = 0;; ++call) {
            const auto plan = std::make_shared<FaultPlan>();
            plan->call = FaultPlan::Call::await;
            plan->fails = call;
            plan->lost = true;
            Told told;
            const auto device = withSpare(std::make_unique<GpuDevice<FaultyGpu>>(DeviceInfo{"faulty", "", false}, plan),
                                          cpu, told.hear());
            const auto bits = referenceTiles(*device);
            if (!plan->failed)
                break;
            QVERIFY2(bits && *bits == right, qPrintable(QString::number(call)));
            QCOMPARE(told.all.size(), std::size_t(1));
            QCOMPARE(device->info().name, std::string("cpu"));
            ++tookOver;
        }
        QVERIFY(tookOver > 5);
    }

    void whereTheSpareOneFailsTooItIsSaid() {
        const auto mishaps = std::make_shared<Mishaps>();
        mishaps->uploads = 0;
        Told told;
        const auto device = withSpare(
            failing(mishaps),
            []() -> Result<std::unique_ptr<Device>> {
                return Error{"there is none", "", ""};
            },
            told.hear());
        const auto image = imageBy(*device);
        QVERIFY(!image && image.error().what == "the device is lost");
        QVERIFY(told.all.empty());
    }
};

QTEST_APPLESS_MAIN(SpareDeviceTest)
#include "spare_device_test.moc"
