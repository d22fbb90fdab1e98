#include <QTest>

#include <atomic>
#include <cstring>
#include <numeric>
#include <thread>
#include <vector>

#include "render/device/gpu/atomic.h"
#include "tests/support/devices/faulty_gpu.h"

using namespace pdr;
using test::FaultPlan;
using test::FaultyGpu;

namespace {

constexpr GpuStream kStream = GpuStream::compute;

struct Square {
    std::int64_t* numbers;
    void operator()(std::int64_t i) const { numbers[i] += i * i; }

    // In a queue: i steps of i each.
    struct Walk {
        std::int64_t index, left;
    };
    bool start(std::int64_t i, Walk& walk) const {
        walk = {i, i};
        return i > 0;
    }
    bool step(Walk& walk) const {
        numbers[walk.index] += walk.index;
        return --walk.left > 0;
    }
};

struct CountUp {
    std::uint64_t *sum, *least;
    std::int32_t *low, *high;
    void operator()(std::int64_t i) const {
        atomicAddTo(*sum, std::uint64_t(i));
        atomicLower(*least, std::uint64_t(i) + 5);
        atomicLower(*low, std::int32_t(i) - 7);
        atomicRaise(*high, std::int32_t(i));
    }
};

/// Blocks a thread until all of `awaited` have come.
struct Meet {
    std::atomic<int>* came;
    int awaited;
    void operator()(std::int64_t) const {
        ++*came;
        for (int patience = 0; *came < awaited && patience < 5000; ++patience)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    struct Walk {};
    bool start(std::int64_t i, Walk&) const {
        (*this)(i);
        return false;
    }
    bool step(Walk&) const { return false; }
};

template <class Launch>
void everyIndexRunsOnce(Launch&& launch) {
    for (const std::int64_t count : {0, 1, 255, 256, 100003}) {
        std::vector<std::int64_t> numbers(std::size_t(count) + 1, 0);
        launch(Square{numbers.data()}, count);
        for (std::int64_t i = 0; i < count; ++i)
            QCOMPARE(numbers[std::size_t(i)], i * i);
        QCOMPARE(numbers[std::size_t(count)], std::int64_t(0));
    }
}

}  // namespace

class HostGpuTest : public QObject {
    Q_OBJECT

  private slots:
    void everyIndexOfAProgramRunsOnce() {
        HostGpu gpu(0, 4);
        everyIndexRunsOnce([&](Square program, std::int64_t count) { gpu.launch(program, count, kStream); });
        everyIndexRunsOnce([&](Square program, std::int64_t count) { gpu.launchQueued(program, count, kStream); });
    }

    void asManyThreadsRunAsWereAskedFor() {
        HostGpu gpu(0, 3);
        std::atomic<int> came = 0;
        gpu.launchQueued(Meet{&came, 3}, 3, kStream);
        QCOMPARE(came.load(), 3);
    }

    void threadsMeetInAtomics() {
        HostGpu gpu(0, 4);
        std::uint64_t sum = 0, least = ~0ull;
        std::int32_t low = 100, high = -100;
        const std::int64_t count = 200000;
        gpu.launch(CountUp{&sum, &least, &low, &high}, count, kStream);
        QCOMPARE(sum, std::uint64_t(count * (count - 1) / 2));
        QCOMPARE(least, std::uint64_t(5));
        QCOMPARE(low, -7);
        QCOMPARE(high, std::int32_t(count - 1));
    }

    void copiesThereAndBackAreTheSameBytes() {
        HostGpu gpu;
        std::vector<std::uint8_t> bytes(1000), back(1000);
        std::iota(bytes.begin(), bytes.end(), std::uint8_t(1));
        void* memory = gpu.allocate(bytes.size());
        QCOMPARE(reinterpret_cast<std::uintptr_t>(memory) % 256, std::uintptr_t(0));
        gpu.copyToDevice(memory, bytes.data(), bytes.size(), kStream);
        gpu.clear(memory, 10, kStream);
        gpu.copyToHost(back.data(), memory, back.size(), GpuStream::copy);
        std::memset(bytes.data(), 0, 10);
        QVERIFY(back == bytes);
        gpu.release(memory);
        QVERIFY(!gpu.takeError());
    }

    void memoryIsCounted() {
        HostGpu gpu(1000000);
        QCOMPARE(gpu.memory().total, std::size_t(1000000));
        void* first = gpu.allocate(300000);
        void* pinned = gpu.allocatePinned(5000000);
        QCOMPARE(gpu.memory().free, std::size_t(700000));
        QCOMPARE(gpu.allocated(), std::size_t(5300000));
        gpu.release(first);
        gpu.release(nullptr);
        gpu.releasePinned(pinned);
        QCOMPARE(gpu.memory().free, std::size_t(1000000));
        QCOMPARE(gpu.allocated(), std::size_t(0));
        QVERIFY(HostGpu().memory().total > std::size_t(1) << 28);
    }

    void whatDoesNotFitIsSaidInBytes() {
        HostGpu gpu(2000000000);
        void* fits = gpu.allocate(20000000);
        QVERIFY(gpu.allocate(2980000000) == nullptr);
        const std::optional<Error> error = gpu.takeError();
        QVERIFY(error);
        QCOMPARE(error->where, std::string("cpu"));
        QVERIFY2(error->what.find("3.0 GB are needed") != std::string::npos, error->what.c_str());
        QVERIFY2(error->what.find("2.0 GB are free") != std::string::npos, error->what.c_str());
        QVERIFY(!error->hint.empty());
        gpu.release(fits);
    }

    void afterAnErrorNothingIsDoneUntilItIsTaken() {
        HostGpu gpu(1000);
        std::int64_t numbers[2] = {3, 3}, other[2] = {8, 8};
        auto* memory = static_cast<std::int64_t*>(gpu.allocate(sizeof numbers));
        gpu.copyToDevice(memory, numbers, sizeof numbers, kStream);
        QVERIFY(gpu.allocate(2000) == nullptr);
        QVERIFY(gpu.allocate(8) == nullptr);
        QVERIFY(gpu.allocatePinned(8) == nullptr);
        gpu.copyToDevice(memory, other, sizeof other, kStream);
        gpu.clear(memory, sizeof numbers, kStream);
        gpu.launch(Square{memory}, 2, kStream);
        gpu.launchQueued(Square{memory}, 2, kStream);
        gpu.copyToHost(other, memory, sizeof other, kStream);
        QCOMPARE(memory[0], std::int64_t(3));
        QCOMPARE(memory[1], std::int64_t(3));
        QCOMPARE(other[0], std::int64_t(8));
        QVERIFY(gpu.takeError()->what.find("too small") != std::string::npos);
        QVERIFY(!gpu.takeError());
        gpu.launch(Square{memory}, 2, kStream);
        QCOMPARE(memory[1], std::int64_t(4));
        QVERIFY(gpu.allocate(2000) == nullptr);
        gpu.release(memory);  // works after an error too
        QCOMPARE(gpu.allocated(), std::size_t(0));
    }

    void aPlannedCallFailsOnceAndALostDeviceForGood() {
        for (const bool lost : {false, true}) {
            const auto plan = std::make_shared<FaultPlan>(FaultPlan{FaultPlan::Call::launch, 1, lost});
            FaultyGpu gpu(plan);
            std::int64_t number[2] = {};
            gpu.launch(Square{number}, 2, kStream);
            QVERIFY(!gpu.takeError());
            gpu.launchQueued(Square{number}, 2, kStream);
            QVERIFY(plan->failed);
            QCOMPARE(number[1], std::int64_t(1));
            QCOMPARE(gpu.takeError()->where, std::string("faulty"));
            gpu.awaitAll();
            QCOMPARE(gpu.takeError().has_value(), lost);
            gpu.launch(Square{number}, 2, kStream);
            QCOMPARE(number[1], std::int64_t(lost ? 1 : 2));
        }
    }
};

QTEST_GUILESS_MAIN(HostGpuTest)
#include "host_gpu_test.moc"
