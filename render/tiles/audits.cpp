#include "render/tiles/audits.h"

#include <algorithm>
#include <utility>

#include "render/tiles/tile_scheduler.h"

namespace pdr {

bool mayCheck(const Worker& worker, const Audit& audit) {
    return !audit.isProof && !audit.second && worker.trust.isProved() && worker.status.key != audit.key &&
           (worker.status.isDeep || !isDeep(audit.lease.samples)) &&
           audit.cost <= worker.speed.perSecond() * kMostCheckSeconds;
}

std::size_t Audits::countOf(WorkerId worker) const {
    return std::size_t(std::ranges::count_if(all_, [&](const Open& open) { return open.audit.worker == worker; }));
}

std::optional<Lease> Audits::give(const Worker& checker, double busySeconds, double now) {
    for (Open& open : all_)
        if (!open.given && mayCheck(checker, open.audit) && open.had.insert(checker.status.id).second) {
            open.given = {checker.status.id, now, busySeconds + open.audit.cost / checker.speed.perSecond()};
            return open.audit.lease;
        }
    return std::nullopt;
}

std::optional<Audit> Audits::takeFrom(WorkerId checker, std::uint64_t lease) {
    return takeOut([&](const Open& open) {
        return open.given && open.given->checker == checker && open.audit.lease.number == lease;
    });
}

void Audits::giveBack(WorkerId checker, std::uint64_t lease) {
    for (Open& open : all_)
        if (open.given && open.given->checker == checker && open.audit.lease.number == lease)
            open.given.reset();
}

void Audits::giveBackAll(WorkerId checker) {
    for (Open& open : all_)
        if (open.given && open.given->checker == checker)
            open.given.reset();
}

std::vector<WorkerId> Audits::expire(double now) {
    std::vector<WorkerId> late;
    for (Open& open : all_)
        if (open.given && now - open.given->since > 4 * open.given->expectedSeconds + TileScheduler::kExpirySeconds) {
            late.push_back(open.given->checker);
            open.given.reset();
        }
    return late;
}

std::optional<Audit> Audits::takeIf(const std::function<bool(const Audit&)>& isOurs) {
    return takeOut([&](const Open& open) { return !open.given && isOurs(open.audit); });
}

std::optional<Audit> Audits::takeLate(double now) {
    return takeOut([&](const Open& open) {
        return !open.given || now - open.given->since > open.given->expectedSeconds + TileScheduler::kOwnHedgeSeconds;
    });
}

std::optional<Audit> Audits::takeOut(const std::function<bool(const Open&)>& isIt) {
    const auto found = std::ranges::find_if(all_, isIt);
    if (found == all_.end())
        return std::nullopt;
    Audit audit = std::move(found->audit);
    all_.erase(found);
    return audit;
}

}  // namespace pdr
