#pragma once
/// The output of a render session, on which a test can wait.

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/session/session.h"

namespace pdr::test {

/// Stores the newest frame and lets a test wait for one.
class Screen {
  public:
    FrameSink sink() {
        return [this](std::shared_ptr<const Frame> frame) {
            const std::lock_guard lock(mutex_);
            if (!frame->notice.empty())
                notices_.push_back(frame->notice);
            else
                newest_ = std::move(frame);
            ++count_;
            arrived_.notify_all();
        };
    }

    /// Waits until `wanted` is true for the newest frame and returns it; null after half an hour, so that a busy
    /// machine causes no failure.
    template <class Wanted>
    std::shared_ptr<const Frame> await(Wanted&& wanted) {
        std::unique_lock lock(mutex_);
        const bool found =
            arrived_.wait_for(lock, std::chrono::minutes(30), [&] { return newest_ && wanted(*newest_); });
        return found ? newest_ : nullptr;
    }

    /// Returns the notices to the user so far.
    std::vector<std::string> notices() {
        const std::lock_guard lock(mutex_);
        return notices_;
    }

    int count() {
        const std::lock_guard lock(mutex_);
        return count_;
    }

  private:
    std::mutex mutex_;
    std::condition_variable arrived_;
    std::shared_ptr<const Frame> newest_;
    std::vector<std::string> notices_;
    int count_ = 0;
};

}  // namespace pdr::test
