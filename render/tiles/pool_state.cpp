#include "render/tiles/pool_state.h"

#include <algorithm>

namespace pdr {
namespace {

/// Fraction of its fair share of the remaining work that a worker gets at a time: portions shrink towards the end, and
/// all workers finish together (guided self-scheduling, Polychronopoulos & Kuck 1987).
constexpr double kShare = 0.4;
/// Cost of the first portion of a worker of unknown speed: some cells.
constexpr double kFirstCost = 16 * kFilmCell * kFilmCell;
/// Limits on the target duration of a portion [s]: minimum, maximum, maximum while the cost of cells is unknown,
/// maximum on probation.
constexpr double kShortestSeconds = 0.004, kLongestSeconds = 0.3, kUnknownSeconds = 0.1, kProbationSeconds = 0.01;

}  // namespace

Ability PoolState::abilityOf(const WorkerSpeed& speed, bool isOnProbation, bool isDeep) const {
    const double mine = speed.perSecond();
    if (mine <= 0)  // unknown: expect the own device's speed
        return {kFirstCost, std::max(own.speed.perSecond(), kFirstCost), 0};
    double all = registry.perSecond(scenes.current().number);
    if (own.helps || !isAnyTaking())
        all += own.speed.perSecond();
    const double fair = request->scheduler().openCost() * mine / std::max(all, mine) * kShare;
    const double longest = isOnProbation ? kProbationSeconds : costs.isKnown() ? kLongestSeconds : kUnknownSeconds;
    return {std::clamp(fair, mine * kShortestSeconds, mine * longest), mine, isDeep ? mine * longest : 0};
}

void PoolState::addTime(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds,
                        double busySeconds) {
    speed.add(request->scheduler().costOf(portion), seconds);
    request->addTime({worker, portion.tile, portion.samples.count, std::min(busySeconds, seconds)});
}

void PoolState::quarantine(const std::string& key, const Text& reason) {
    for (const WorkerId worker : registry.quarantine(key, reason))
        if (request)
            request->scheduler().giveBackAll(worker);
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
