#include <QTest>

#include "app/bench/commands.h"
#include "render/device/device_list.h"

using namespace pdr;

/// Tests the CUDA device if there is one, and otherwise that its absence is reported. gpu_device_test tests all that it
/// computes, without a GPU, too.
class CudaDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    void withoutAGpuTheReasonIsGivenAndTheCpuTakesItsPlace() {
        const auto gpu = openDevice("cuda");
        if (gpu)
            QSKIP("there is a GPU here");
        QCOMPARE(gpu.error().where, std::string("cuda"));
        QVERIFY(!gpu.error().what.empty() && gpu.error().hint.find("CPU") != std::string::npos);
        QCOMPARE((*openDevice("auto"))->info().name, std::string("cpu"));
        QCOMPARE(devicesHere().size(), std::size_t(1));
        QVERIFY(!openDevice("cuda:1") && !openDevice("cuda:"));
        QVERIFY(!openDevice("cuda:-1") && !openDevice("gpu"));
    }

    void theGpuRendersAsTheCpuDoes() {
        const auto gpu = openDevice("cuda");
        if (!gpu)
            QSKIP(gpu.error().text().c_str());
        QCOMPARE(bench::parity({"--device", "cuda"}), 0);
    }
};

QTEST_APPLESS_MAIN(CudaDeviceTest)
#include "cuda_device_test.moc"
