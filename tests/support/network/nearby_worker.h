#pragma once
/// A render node without a network, on a thread of its own.

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

#include "render/tiles/trace_lease.h"
#include "render/tiles/worker_pool.h"

namespace pdr::test {

/// A node without a network, which takes leases from the pool on a thread of its own.
class NearbyWorker {
  public:
    enum class Nature {
        honest,
        lies,
        liesSeldom,
        silent,
        sendsOthers,
        tellsFaults,    ///< reports a fault that did not occur
        hidesFaults,    ///< reports no faults
        hidesSeldom,    ///< reports no faults, once it is trusted
        tellsTooMany,   ///< reports more faults than samples, once it is trusted
        tellsOfOthers,  ///< reports a fault of a sample that it was not asked for, once it is trusted
    };

    NearbyWorker(std::shared_ptr<WorkerPool> pool, const std::string& key, Nature nature = Nature::honest,
                 bool isDeep = true)
        : pool_(std::move(pool)),
          id_(pool_->join(key, key, isDeep)),
          nature_(nature),
          device_(makeCpuDevice(1)),
          thread_([this](const std::stop_token& stop) { run(stop); }) {}
    ~NearbyWorker() {
        thread_.request_stop();
        thread_.join();
        pool_->leave(id_);
    }

    /// Returns the number of leases of several blocks that it had.
    int deepLeases() const { return deep_; }
    WorkerStatus status() const {
        for (const WorkerStatus& one : pool_->workers())
            if (one.id == id_)
                return one;
        return {};
    }

  private:
    void run(const std::stop_token& stop) {
        std::uint64_t have = 0;
        while (!stop.stop_requested()) {
            const PublishedScene scene = pool_->scene();
            if (scene.scene && scene.number != have) {
                (void)device_->upload(*scene.scene);
                width_ = scene.scene->film.x;
                pool_->hasScene(id_, have = scene.number);
            }
            if (const auto lease = pool_->take(id_); lease && nature_ != Nature::silent)
                answer(*lease);
            else
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            pool_->tick();
        }
    }

    std::uint32_t firstPixelOf(const Lease& lease) const { return std::uint32_t(lease.tile.y * width_ + lease.tile.x); }

    void answer(const Lease& lease) {
        LeaseResult result = *traceLease(*device_, lease, {});
        ++answers_;
        deep_ += isDeep(lease.samples);
        const bool isTrusted = answers_ > 80;
        if (nature_ == Nature::lies || (nature_ == Nature::liesSeldom && isTrusted)) {
            double& red = isDeep(result.samples) ? result.moments.back().mean.x : result.sums.back().sum.x;
            red = std::nextafter(red, 1e9);
        }
        if (nature_ == Nature::tellsFaults)
            result.health.add(Fault::infinite, result.samples.first, firstPixelOf(lease));
        if (nature_ == Nature::hidesFaults || (nature_ == Nature::hidesSeldom && isTrusted))
            result.health = {};
        if (nature_ == Nature::tellsTooMany && isTrusted)
            result.health.faults[1] = {std::uint64_t(workOf(result.tile, result.samples)) + 1, result.samples.first,
                                       firstPixelOf(lease)};
        if (nature_ == Nature::tellsOfOthers && isTrusted)
            result.health.add(Fault::infinite, result.samples.end(), firstPixelOf(lease));
        if (nature_ == Nature::sendsOthers)
            result.tile.x += kFilmCell;
        pool_->deliver(id_, std::move(result));
    }

    std::shared_ptr<WorkerPool> pool_;
    WorkerId id_;
    Nature nature_;
    std::unique_ptr<Device> device_;
    int answers_ = 0;
    std::atomic<int> deep_ = 0;
    int width_ = 0;  ///< width of the image
    std::jthread thread_;
};

}  // namespace pdr::test
