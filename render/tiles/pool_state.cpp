#include "render/tiles/pool_state.h"

#include <algorithm>
#include <utility>

#include "render/tiles/result_check.h"

namespace pdr {
namespace {

/// Fraction of its fair share of the remaining work that a worker gets at a time: portions shrink towards the end, and
/// all workers finish together (guided self-scheduling, Polychronopoulos & Kuck 1987).
constexpr double kShare = 0.4;
/// Cost of the first portion of a worker of unknown speed: some cells.
constexpr double kFirstCost = 16 * kFilmCell * kFilmCell;
/// Limits on the target duration of a portion [s]: minimum, maximum, maximum while the cost of cells is unknown.
constexpr double kShortestSeconds = 0.004, kLongestSeconds = 0.3, kUnknownSeconds = 0.1;

}  // namespace

bool PoolState::isAnyTaking() const {
    if (!isRequestCurrent())
        return false;
    return std::ranges::any_of(registry.all(), [&](const auto& one) {
        const Worker& worker = one.second;
        return worker.takesWork(request->scene()) &&
               (!worker.trust.isStranger() || worker.inFlight > 0 || request->affordsProof());
    });
}

bool PoolState::mayAnyCheck(const Audit& audit) const {
    return isRequestCurrent() && std::ranges::any_of(registry.all(), [&](const auto& one) {
               return one.second.takesWork(request->scene()) && mayCheck(one.second, audit);
           });
}

std::optional<Lease> PoolState::leaseFor(const Worker& worker, double now) {
    const WorkerId id = worker.status.id;
    const double held = request->scheduler().costHeldBy(id);
    const Ability ability = abilityOf(worker.speed, worker.status.isDeep);
    if (std::optional<Lease> audit = request->audits().give(worker, held / ability.perSecond, now))
        return audit;
    std::optional<Portion> portion;
    if (!worker.trust.isProved())
        portion = request->takeProof(id, ability, now);
    if (!portion && !worker.trust.isStranger())
        portion = request->scheduler().take(id, ability, now);
    if (!portion)
        return std::nullopt;
    Lease lease = request->leaseOf(*portion);
    lease.isKept = kept.has(id, portion->tile, portion->samples);
    return lease;
}

Ability PoolState::abilityOf(const WorkerSpeed& speed, bool isDeep) const {
    const double mine = speed.perSecond();
    if (mine <= 0)  // unknown: expect the own device's speed
        return {kFirstCost, std::max(own.speed.perSecond(), kFirstCost), 0};
    double all = registry.perSecond(scenes.current().number);
    if (own.helps || !isAnyTaking())
        all += own.speed.perSecond();
    const double fair = request->scheduler().openCost() * mine / std::max(all, mine) * kShare;
    const double longest = costs.isKnown() ? kLongestSeconds : kUnknownSeconds;
    return {std::clamp(fair, mine * kShortestSeconds, mine * longest), mine, isDeep ? mine * longest : 0};
}

void PoolState::addTime(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds,
                        double busySeconds) {
    speed.add(request->scheduler().costOf(portion), seconds);
    request->addTime({worker, portion.tile, portion.samples.count, std::min(busySeconds, seconds)});
}

void PoolState::count(Worker* worker, const Portion& portion) {
    ++checks.results;
    checks.work += workOf(portion.tile, portion.samples);
    if (worker)
        worker->count(portion);
}

Result<void> PoolState::conclude(const Audit& audit, LeaseResult truth) {
    const LeaseResult& claimed = audit.claimed;
    const Text lied = phrase("a tile of it was not what this machine found when it did it again");
    const bool isConfirmed = confirms(truth, audit);
    const bool isSecondWrong = audit.second && !isSame(truth, audit.second->result);
    if (isSecondWrong)
        quarantine(audit.second->key, lied);
    if (!isConfirmed)
        quarantine(audit.key, lied);
    checks.wrong += (isConfirmed ? 0 : 1) + (isSecondWrong ? 1 : 0);
    if (audit.isWithheld) {
        truth.number = claimed.number;
        if (Result<void> taken = request->take(std::move(truth)); !taken)
            return taken;
        kept.took(isConfirmed ? audit.worker : kOwnDevice, claimed.tile, claimed.samples);
    }
    if (!isConfirmed)
        return {};
    const Portion portion{claimed.number, claimed.tile, claimed.samples};
    Worker* worker = registry.find(audit.worker);
    if (audit.isWithheld)
        count(worker, portion);
    checks.checked += workOf(portion.tile, portion.samples);
    if (worker) {
        worker->trust.confirmed(audit.cost);
        ++worker->status.audited;
    }
    return {};
}

void PoolState::forgetFilm() {
    earlierChecks += std::exchange(checks, {});
    kept.clear();
}

void PoolState::quarantine(const std::string& key, const Text& reason) {
    for (const WorkerId worker : registry.quarantine(key, reason))
        if (request)
            request->giveBackAll(worker);
}

void PoolState::setNotice(std::function<void()> notice) {
    const std::lock_guard lock(noticeMutex_);
    notice_ = std::move(notice);
}

void PoolState::notify() const {
    const std::lock_guard lock(noticeMutex_);
    if (notice_)
        notice_();
}

}  // namespace pdr
