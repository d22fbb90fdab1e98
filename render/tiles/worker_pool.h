#pragma once
/// The workers (threads, or render nodes behind a network) that sample images beside this program's own device. Two
/// sides use a pool, each from its own threads, and each through the face that it needs: the transport serves leases to
/// the workers, and the device that renders an image shares its work. The owner of the pool sees both faces, sets how
/// work is shared, and reads the status. Thread-safe; pool_state.h describes the locks.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "render/base/split.h"
#include "render/tiles/lease_server.h"
#include "render/tiles/shared_work.h"
#include "render/timing/split_choice.h"

namespace pdr {

/// Monotonic seconds since an arbitrary epoch.
using PoolClock = std::function<double()>;
/// The default clock.
double poolSeconds();

class WorkerPool final : public LeaseServer, public SharedWork {
  public:
    /// `seed`: for choosing audits, which workers must not be able to predict.
    explicit WorkerPool(std::uint64_t seed, PoolClock clock = poolSeconds);

    /// Pins how requests are split; none: the cost model decides (timing/split_choice.h).
    void setSplit(std::optional<Split> split);
    /// Returns the split of the last request, with the reason.
    SplitChoice split() const;
    /// Sets whether the own device renders, too. False: it only audits, unless no worker takes work.
    void setOwnHelps(bool helps);
    /// Sets whether every result of a worker is rendered a second time, by another worker or by the own device, before
    /// a film has it: twice the work.
    void setChecksAll(bool all);
    /// Work that the own device has done for requests.
    double ownWork() const;
    /// Status of all connected workers, in the sequence in which they joined.
    std::vector<WorkerStatus> workers() const;

  private:
    explicit WorkerPool(const std::shared_ptr<PoolState>& state);

    std::shared_ptr<PoolState> state_;
};

}  // namespace pdr
