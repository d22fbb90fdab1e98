#include "render/tiles/lease_renderer.h"

#include <utility>

#include "render/tiles/trace_lease.h"

namespace pdr {

LeaseRenderer::LeaseRenderer(std::unique_ptr<Device> device, Answered answered)
    : device_(std::move(device)),
      answered_(std::move(answered)),
      thread_([this](const std::stop_token& ended) { run(ended); }) {}

void LeaseRenderer::setScene(std::uint64_t number, std::shared_ptr<const Scene> scene) {
    const std::lock_guard lock(mutex_);
    dropLeases();
    next_ = std::move(scene);
    number_ = number;
    isNew_ = true;
    changed_.notify_all();
}

void LeaseRenderer::add(Lease lease) {
    const std::lock_guard lock(mutex_);
    leases_.push_back(std::move(lease));
    changed_.notify_all();
}

void LeaseRenderer::dropLeases() {
    leases_.clear();
    current_.request_stop();
}

void LeaseRenderer::forget() {
    setScene(0, nullptr);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !isNew_ && !isBusy_; });
}

void LeaseRenderer::drop() {
    const std::lock_guard lock(mutex_);
    dropLeases();
}

void LeaseRenderer::run(const std::stop_token& ended) {
    const std::stop_callback end(ended, [this] {
        const std::lock_guard lock(mutex_);
        dropLeases();
    });
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ended, [this] { return isNew_ || !leases_.empty(); })) {
        isBusy_ = true;
        // Load the newest scene, or render the oldest lease
        if (std::exchange(isNew_, false)) {
            const std::shared_ptr<const Scene> scene = std::exchange(next_, nullptr);
            const std::uint64_t number = number_;
            lock.unlock();
            takeScene(number, scene);
        } else {
            Lease lease = std::move(leases_.front());
            leases_.pop_front();
            current_ = {};
            const std::stop_token stop = current_.get_token();
            const bool isStale = lease.scene != number_;
            lock.unlock();
            if (!isStale)
                take(std::move(lease), stop);
        }
        lock.lock();
        isBusy_ = false;
        changed_.notify_all();
    }
    lock.unlock();
    (void)device_->unload();  // an error can no longer be reported
}

void LeaseRenderer::takeScene(std::uint64_t number, const std::shared_ptr<const Scene>& scene) {
    const Result<void> taken = scene ? device_->upload(*scene) : device_->unload();
    if (!scene)
        return;
    answered_(SceneTaken{number, taken ? std::optional<Error>() : taken.error()});
}

void LeaseRenderer::take(Lease lease, const std::stop_token& stop) {
    const std::uint64_t number = lease.number;
    Result<LeaseResult> result = traceLease(*device_, std::move(lease), stop);
    if (stop.stop_requested())
        return;
    if (result)
        answered_(*std::move(result));
    else
        answered_(LeaseLost{number, result.error()});
}

}  // namespace pdr
