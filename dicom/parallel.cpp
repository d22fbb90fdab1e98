#include "dicom/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace pdr::dicom {

namespace {

constexpr auto kReportEvery = std::chrono::milliseconds(20);

}  // namespace

bool onAllCores(std::size_t count, const std::function<void(std::size_t, const GoOn&)>& work, const Progress& progress,
                std::string_view step) {
    if (!progress(0.0, step))
        return false;
    std::atomic<std::size_t> next = 0, done = 0;
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::condition_variable finished;
    std::exception_ptr thrown;  // the first one; guarded by mutex
    // Take one index after the other, and keep the first exception
    const GoOn goOn = [&stop] { return !stop; };
    const auto each = [&] {
        for (std::size_t i = next++; i < count && !stop; i = next++) {
            work(i, goOn);
            if (++done == count) {
                const std::lock_guard lock(mutex);
                finished.notify_one();
            }
        }
    };
    const auto worker = [&] {
        try {
            each();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!thrown)
                thrown = std::current_exception();
            stop = true;
            finished.notify_one();
        }
    };
    // Start a thread for each core
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> threads;
    try {
        for (std::size_t i = 0; i < std::min(cores, count); ++i)
            threads.emplace_back(worker);
    } catch (const std::exception&) {  // no thread left, or no memory for it
        if (threads.empty())
            throw;
    }

    // Report progress until all is done
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, kReportEvery, [&] { return thrown || done == count; })) {
        if (!progress(double(done) / double(count), step)) {
            stop = true;
            return false;
        }
    }
    if (thrown)
        std::rethrow_exception(thrown);
    return progress(1.0, step);
}

}  // namespace pdr::dicom
