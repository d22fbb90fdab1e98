#pragma once
/// The results of workers that are rendered a second time and compared, by another worker or by the own device. A
/// worker gets an audit as a lease like any other. Where two workers differ the own device decides. Not thread-safe:
/// see pool_state.h.

#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/tiles/worker.h"

namespace pdr {

/// A result, or a part of one, that is rendered again and compared.
struct Audit {
    /// What another worker sent for the same samples, which differs.
    struct Opinion {
        std::string key;  ///< key of that worker
        LeaseResult result;
    };

    WorkerId worker = kOwnDevice;
    std::string key;          ///< key of the worker
    LeaseResult claimed;      ///< what the worker sent; for a part, with the faults of the whole
    Lease lease;              ///< what another machine renders to compare it
    double cost = 0;          ///< cost of the lease
    bool isWithheld = false;  ///< the result is merged only after the audit
    bool isProof = false;     ///< the worker is not proved: only the own device may judge it
    std::optional<Opinion> second = std::nullopt;
};

/// Whether `worker` may render the samples of the audit: it is proved, is not the one that is audited, and takes at
/// most kMostCheckSeconds.
bool mayCheck(const Worker& worker, const Audit& audit);
inline constexpr double kMostCheckSeconds = 1;

class Audits {
  public:
    bool areDone() const { return all_.empty(); }
    /// Number of audits of results of that worker.
    std::size_t countOf(WorkerId worker) const;
    void add(Audit audit) { all_.push_back({std::move(audit)}); }

    /// Gives `checker` the oldest audit that it may check, has not had, and no other has; none: there is none.
    /// `busySeconds`: the time that it needs for what it has already.
    std::optional<Lease> give(const Worker& checker, double busySeconds, double now);
    /// Takes out the audit that `checker` has under that number of a lease; none: it has no such audit.
    std::optional<Audit> takeFrom(WorkerId checker, std::uint64_t lease);
    /// Takes back an audit, or all, that `checker` will not deliver.
    void giveBack(WorkerId checker, std::uint64_t lease);
    void giveBackAll(WorkerId checker);
    /// Takes overdue audits back; returns the workers that had them.
    std::vector<WorkerId> expire(double now);

    /// Takes out the oldest audit that nobody has and for which `isOurs`; none: there is none.
    std::optional<Audit> takeIf(const std::function<bool(const Audit&)>& isOurs);
    /// Takes out the oldest audit that nobody has, or whose checker is late; none: there is none.
    std::optional<Audit> takeLate(double now);

  private:
    struct Given {
        WorkerId checker = kOwnDevice;
        double since = 0, expectedSeconds = 0;
    };
    struct Open {
        Audit audit;
        std::optional<Given> given = std::nullopt;  ///< who renders it; none: nobody does
        std::set<WorkerId> had = {};                ///< who has had it: a lease is given to nobody twice
    };

    std::optional<Audit> takeOut(const std::function<bool(const Open&)>& isIt);

    std::deque<Open> all_;  ///< the oldest first
};

}  // namespace pdr
