#pragma once
/// Ctrl-C and SIGTERM as signals that the program polls when it has time.

#include <signal.h>
#include <time.h>

#include <chrono>
#include <stop_token>
#include <thread>

namespace pdr::bench {

/// Blocks the signals until they are polled. Must be constructed before any thread starts, because threads inherit the
/// blocked signals.
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

    /// Returns whether a signal has come. Must be called by one thread only.
    bool came() {
        const timespec now{0, 0};
        came_ = came_ || sigtimedwait(&set_, nullptr, &now) > 0;
        return came_;
    }

  private:
    sigset_t set_, before_;
    bool came_ = false;
};

/// Turns the signals into a stop request, on a thread of its own, so that it works while all others are busy. No other
/// thread may then poll `signals`.
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
