#pragma once
/// A render node without a network: it asks a pool for leases from a thread of its own.

#include <chrono>
#include <thread>

#include "render/tiles/trace_lease.h"
#include "render/tiles/worker_pool.h"

namespace pdr::test {

class HonestWorker {
  public:
    HonestWorker(std::shared_ptr<WorkerPool> pool, const std::string& name)
        : pool_(std::move(pool)),
          id_(pool_->join(name, name)),
          thread_([this](const std::stop_token& stop) { run(stop); }) {}
    ~HonestWorker() {
        thread_.request_stop();
        thread_.join();
        pool_->leave(id_);
    }

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
            if (scene.scene && scene.number != have && device_->upload(*scene.scene))
                pool_->hasScene(id_, have = scene.number);
            if (const auto lease = pool_->take(id_))
                pool_->deliver(id_, *traceLease(*device_, *lease, {}));
            else
                std::this_thread::sleep_for(std::chrono::microseconds(200));
            pool_->tick();
        }
    }

    std::shared_ptr<WorkerPool> pool_;
    WorkerId id_;
    std::unique_ptr<Device> device_ = makeCpuDevice(1);
    std::jthread thread_;
};

}  // namespace pdr::test
