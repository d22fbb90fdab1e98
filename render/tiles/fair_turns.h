#pragma once
/// FairTurns at the processors of a machine, or at a GPU, which several users share. One of them has it at a time, for
/// one lease. Whoever has had the least time is next, so that users who always want more get equal shares, however long
/// their leases take. Thread-safe.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <utility>
#include <vector>

#include "render/base/processor_time.h"

namespace pdr {

class FairTurns {
  public:
    /// Time in seconds since an arbitrary epoch, of which turns are charged. Processor time does not charge a user for
    /// what other programs, or a stop of this one, have cost; for a GPU it must be monotonic time instead.
    using Clock = std::function<double()>;

    /// The account of one user.
    class Share {
        friend class FairTurns;
        double counted_ = 0;  ///< decides who is next [s]
        double had_ = 0;      ///< time of all turns [s]
    };

    explicit FairTurns(Clock clock = processorSeconds) : clock_(std::move(clock)) {}

    /// Waits for a turn, calls `work` on this thread, and charges `share`, which one thread at a time may use. Returns
    /// false, without a call, if a stop was requested before.
    bool take(Share& share, const std::stop_token& stop, const std::function<void()>& work);
    /// Returns the time of all turns of that user, in seconds.
    double had(const Share& share) const;
    /// Returns how many users wait for a turn.
    std::size_t waiting() const;

    /// Most seconds by which a user who wanted nothing is ahead of the others afterwards. Gaps between leases are not
    /// held against it, and an idle hour is no claim to the next one.
    static constexpr double kMostLead = 0.2;

  private:
    bool isNext(const Share& share) const;

    Clock clock_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::vector<const Share*> waiting_;  ///< by arrival
    bool isTaken_ = false;
    double reached_ = 0;  ///< highest count at which a turn began [s]
};

}  // namespace pdr
