#pragma once
/// Ctrl-C and SIGTERM as a question that is asked when there is time for the answer.

#include <signal.h>
#include <time.h>

#include <chrono>
#include <stop_token>
#include <thread>

namespace pdr::bench {

/// They wait until somebody asks for them. Made before any thread starts: threads inherit it.
class HeldSignals {
  public:
    HeldSignals() {
        sigemptyset(&set_);
        sigaddset(&set_, SIGINT);
        sigaddset(&set_, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &set_, &before_);
    }
    ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// Of one thread.
    bool came() {
        const timespec now{0, 0};
        came_ = came_ || sigtimedwait(&set_, nullptr, &now) > 0;
        return came_;
    }

  private:
    sigset_t set_, before_;
    bool came_ = false;
};

/// Turns them into a stop request, also while everybody else is busy. Nobody else may then ask `signals`.
class StopOnSignal {
  public:
    explicit StopOnSignal(HeldSignals& signals)
        : watch_([this, &signals](std::stop_token ended) {
              while (!ended.stop_requested() && !signals.came())
                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
              if (!ended.stop_requested())
                  stop_.request_stop();
          }) {}

    std::stop_token token() const { return stop_.get_token(); }

  private:
    std::stop_source stop_;
    std::jthread watch_;
};

}  // namespace pdr::bench
