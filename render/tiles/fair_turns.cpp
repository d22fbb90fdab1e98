#include "render/tiles/fair_turns.h"

#include <algorithm>

namespace pdr {

bool FairTurns::take(Share& share, const std::stop_token& stop, const std::function<void()>& work) {
    std::unique_lock lock(mutex_);
    // Wait
    share.counted_ = std::max(share.counted_, reached_ - kMostLead);
    waiting_.push_back(&share);
    const bool isMine = changed_.wait(lock, stop, [&] { return !isTaken_ && isNext(share); });
    std::erase(waiting_, &share);
    changed_.notify_all();
    if (!isMine)
        return false;
    // Work
    isTaken_ = true;
    reached_ = std::max(reached_, share.counted_);
    const double start = clock_();
    lock.unlock();
    work();
    lock.lock();
    // Charge
    const double seconds = clock_() - start;
    share.counted_ += seconds;
    share.had_ += seconds;
    isTaken_ = false;
    changed_.notify_all();
    return true;
}

bool FairTurns::isNext(const Share& share) const {
    return *std::ranges::min_element(waiting_, {}, [](const Share* one) { return one->counted_; }) == &share;
}

double FairTurns::had(const Share& share) const {
    const std::lock_guard lock(mutex_);
    return share.had_;
}

std::size_t FairTurns::waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size();
}

}  // namespace pdr
