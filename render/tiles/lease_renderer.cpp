#include "render/tiles/lease_renderer.h"

#include <utility>

#include "render/tiles/trace_lease.h"

namespace pdr {

LeaseRenderer::LeaseRenderer(std::unique_ptr<Device> device, FairTurns& turns, Answered answered)
    : device_(std::move(device)),
      turns_(turns),
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

void LeaseRenderer::drop() {
    const std::lock_guard lock(mutex_);
    dropLeases();
}

void LeaseRenderer::run(const std::stop_token& ended) {
    const std::stop_callback end(ended, [this] {
        const std::lock_guard lock(mutex_);
        isNew_ = false;
        dropLeases();
    });
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ended, [this] { return isNew_ || !leases_.empty(); })) {
        current_ = {};
        const std::stop_token stop = current_.get_token();
        lock.unlock();
        (void)turns_.take(share_, stop, [this] { work(); });
        lock.lock();
    }
    lock.unlock();
    (void)device_->unload();  // an error can no longer be reported
}

void LeaseRenderer::work() {
    std::unique_lock lock(mutex_);
    current_ = {};
    const std::stop_token stop = current_.get_token();
    const std::uint64_t number = number_;
    if (std::exchange(isNew_, false)) {
        const std::shared_ptr<const Scene> scene = std::exchange(next_, nullptr);
        lock.unlock();
        takeScene(number, *scene);
    } else if (!leases_.empty()) {
        Lease lease = std::move(leases_.front());
        leases_.pop_front();
        lock.unlock();
        if (lease.scene == number)
            take(std::move(lease), stop);
    }
}

void LeaseRenderer::takeScene(std::uint64_t number, const Scene& scene) {
    const Result<void> taken = device_->upload(scene);
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
