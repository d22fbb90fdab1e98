#include <QTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/bench/paper/device_load.h"
#include "render/base/processor_time.h"

using namespace pdr::bench;
using std::chrono::milliseconds;

// fake_nvml.cpp, which dlopen() finds instead of the driver's
extern "C" std::atomic<std::chrono::steady_clock::time_point> fakeNvmlBusySince;
extern "C" std::atomic<int> fakeNvmlSettledAnswers;

class DeviceLoadTest : public QObject {
    Q_OBJECT

    template <class Work>
    static double during(DeviceLoad& load, Work&& work) {
        load.start();
        work();
        return load.stop().value_or(-1);
    }
    static void wait() { std::this_thread::sleep_for(milliseconds(80)); }
    /// Computes until the thread has had 80 ms of a processor that others use too.
    static void compute() {
        for (const double start = pdr::processorSeconds(); pdr::processorSeconds() - start < 0.08;) {
        }
    }

  private slots:
    void processorThatWaitsIsIdlerThanOneThatComputes() {
        const auto load = processorLoad(1);
        const double waiting = during(*load, wait);
        const double computing = during(*load, compute);
        QVERIFY(waiting >= 0 && computing <= 1);
        QVERIFY(waiting < computing);
    }

    void moreThreadsShareTheSameWork() {
        const double alone = during(*processorLoad(1), compute);
        const double oneOfMany = during(*processorLoad(100), compute);
        QVERIFY(oneOfMany <= 0.0101 && oneOfMany < alone);
    }

    /// The driver's first answers are about the time before.
    void gpuIsAsBusyAsItsDriverSaysAfterAWhile() {
        const auto load = gpuLoad(0);
        fakeNvmlSettledAnswers = 0;
        fakeNvmlBusySince = std::chrono::steady_clock::now();
        load->start();
        while (fakeNvmlSettledAnswers < 3)
            std::this_thread::sleep_for(milliseconds(20));
        const auto busy = load->stop();
        QVERIFY(busy.has_value());
        QVERIFY(std::fabs(*busy - 0.6) < 1e-9);
    }

    void shortTimeOrNoGpuIsNotGuessed() {
        const auto load = gpuLoad(0);
        load->start();
        QVERIFY(!load->stop());
        const auto none = gpuLoad(7);
        none->start();
        std::this_thread::sleep_for(milliseconds(400));
        QVERIFY(!none->stop());
    }

    void deviceNamesChooseTheSource() {
        QVERIFY(loadOf("cpu", 2)->source() == "processor time of 2 threads");
        QVERIFY(loadOf("cuda", 0)->source() == gpuLoad(0)->source());
        const auto second = loadOf("cuda:1", 0);  // there is only one
        second->start();
        std::this_thread::sleep_for(milliseconds(400));
        QVERIFY(!second->stop());
    }
};

QTEST_GUILESS_MAIN(DeviceLoadTest)
#include "device_load_test.moc"
