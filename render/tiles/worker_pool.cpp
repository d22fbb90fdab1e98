#include "render/tiles/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "render/tiles/result_check.h"

namespace pdr {
namespace {

/// Fraction of its fair share of the remaining work that a worker gets at a time: portions shrink towards the end, and
/// all workers finish together (guided self-scheduling, Polychronopoulos & Kuck 1987).
constexpr double kShare = 0.4;
/// Cost of the first portion of a worker of unknown speed: some cells.
constexpr double kFirstCost = 16 * kFilmCell * kFilmCell;

}  // namespace

double poolSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

WorkerPool::WorkerPool(std::uint64_t seed, PoolClock clock) : clock_(std::move(clock)), seed_(seed) {}

void WorkerPool::setNotice(std::function<void()> notice) {
    const std::lock_guard lock(noticeMutex_);
    notice_ = std::move(notice);
}

void WorkerPool::tell() const {
    const std::lock_guard lock(noticeMutex_);
    if (notice_)
        notice_();
}

WorkerId WorkerPool::join(const std::string& key, const std::string& name) {
    const std::lock_guard lock(mutex_);
    const WorkerId id = nextWorker_++;
    Worker& worker = workers_.emplace(id, Worker(id, key, name, seed_ + id)).first->second;
    if (const auto past = past_.find(key); past != past_.end()) {
        worker.trust = past->second.trust;
        if (!past->second.quarantine.empty())
            caught(worker, past->second.quarantine);
        past_.erase(past);
    }
    return id;
}

void WorkerPool::leave(WorkerId id) {
    {
        const std::lock_guard lock(mutex_);
        Worker* worker = find(id);
        if (!worker)
            return;
        if (order_)
            order_->scheduler().giveBackAll(id);
        past_.insert_or_assign(worker->status.key,
                               Past{worker->trust, worker->isQuarantined() ? worker->status.reason : Text()});
        workers_.erase(id);
        changed_.notify_all();
    }
    tell();
}

Worker* WorkerPool::find(WorkerId id) {
    const auto found = workers_.find(id);
    return found == workers_.end() ? nullptr : &found->second;
}

PublishedScene WorkerPool::scene() const {
    const std::lock_guard lock(mutex_);
    return wanted();
}

void WorkerPool::hasScene(WorkerId id, std::uint64_t scene) {
    const std::lock_guard lock(mutex_);
    if (Worker* worker = find(id)) {
        worker->scene = scene;
        worker->inFlight = 0;
        worker->status.reason = {};
        worker->updateState();
    }
}

void WorkerPool::cannotTakeScene(WorkerId id, const Text& reason) {
    const std::lock_guard lock(mutex_);
    if (Worker* worker = find(id)) {
        worker->scene = 0;
        worker->status.reason = reason;
        worker->updateState();
    }
}

void WorkerPool::setSuspect(WorkerId id, bool suspect) {
    {
        const std::lock_guard lock(mutex_);
        Worker* worker = find(id);
        if (!worker || worker->isSuspect == suspect)
            return;
        worker->isSuspect = suspect;
        worker->updateState();
        if (order_)
            order_->scheduler().setSuspect(id, suspect);
        changed_.notify_all();
    }
    tell();
}

void WorkerPool::setPaused(WorkerId id, bool paused) {
    {
        const std::lock_guard lock(mutex_);
        if (Worker* worker = find(id)) {
            worker->isPaused = paused;
            worker->updateState();
        }
    }
    tell();
}

void WorkerPool::setDraining(WorkerId id) {
    const std::lock_guard lock(mutex_);
    if (Worker* worker = find(id)) {
        worker->isDraining = true;
        worker->updateState();
    }
}

Ability WorkerPool::abilityOf(const WorkerSpeed& speed, bool isOnProbation) const {
    double all = ownHelps_ || !anyTakesWork() ? ownSpeed_.perSecond() : 0;
    for (const auto& [other, worker] : workers_)
        if (worker.takesWork(wanted().number))
            all += worker.speed.perSecond();
    const double mine = speed.perSecond();
    if (mine <= 0)  // unknown: expect the own device's speed
        return {kFirstCost, std::max(ownSpeed_.perSecond(), kFirstCost)};
    const double fair = order_->scheduler().openCost() * mine / std::max(all, mine) * kShare;
    const double longest = isOnProbation ? kProbationSeconds : costs_.isKnown() ? kLongestSeconds : kUnknownSeconds;
    return {std::clamp(fair, mine * kShortestSeconds, mine * longest), mine};
}

bool WorkerPool::anyTakesWork() const {
    return isOrderWanted() &&
           std::ranges::any_of(workers_, [&](const auto& one) { return one.second.takesWork(order_->scene()); });
}

std::optional<Lease> WorkerPool::take(WorkerId id) {
    const std::lock_guard lock(mutex_);
    Worker* worker = find(id);
    if (!isOrderWanted() || !worker || !worker->takesWork(order_->scene()))
        return std::nullopt;
    const bool probation = worker->trust.isOnProbation();
    if (worker->inFlight >= (probation ? 1 : kInFlight))
        return std::nullopt;
    const double now = clock_();
    const Ability ability = abilityOf(worker->speed, probation);
    const std::optional<Portion> portion = order_->scheduler().take(id, ability, now);
    if (!portion)
        return std::nullopt;
    if (worker->inFlight++ == 0)
        worker->lastResult = now;
    return order_->leaseOf(*portion);
}

void WorkerPool::deliver(WorkerId id, LeaseResult result) {
    {
        const std::lock_guard lock(mutex_);
        Worker* worker = find(id);
        if (!worker)
            return;
        worker->inFlight = std::max(worker->inFlight - 1, 0);
        const std::optional<Portion> portion =
            order_ ? order_->scheduler().heldBy(id, result.number) : std::optional<Portion>();
        if (!portion) {
            ++worker->status.late;
            worker->lastResult = clock_();
        } else if (const std::string why = whatIsImpossible(result, *portion, wanted().scene->film.x); !why.empty()) {
            caught(*worker, why);
        } else {
            const double now = clock_();
            timed(id, worker->speed, *portion, now - worker->lastResult, result.seconds);
            times_.add(workOf(result.tile, result.samples), now - worker->lastResult);
            worker->lastResult = now;
            worker->status.busySeconds += result.seconds;
            if (worker->trust.isOnProbation())
                order_->withhold(worker->status, *portion, std::move(result));
            else
                believe(*worker, *portion, std::move(result));
        }
        changed_.notify_all();
    }
    tell();
}

void WorkerPool::timed(WorkerId worker, WorkerSpeed& speed, const Portion& portion, double seconds,
                       double busySeconds) {
    speed.add(order_->scheduler().costOf(portion), seconds);
    timed_.push_back({worker, portion.tile, portion.samples.count, std::min(busySeconds, seconds)});
}

void WorkerPool::believe(Worker& worker, const Portion& portion, LeaseResult result) {
    if (const std::optional<Tile> part = worker.trust.partToAudit(result.tile))
        order_->auditPart(worker.status, portion, result, *part);
    if (Result<void> taken = order_->take(std::move(result)); !taken)
        return caught(worker, taken.error().what);
    believed_.insert(worker.status.key);
    worker.count(portion);
}

void WorkerPool::caught(Worker& worker, const Text& reason) {
    if (!worker.isQuarantined()) {
        worker.status.state = WorkerState::quarantined;
        worker.status.reason = reason;
    }
    liars_.insert(worker.status.key);
    if (order_)
        order_->scheduler().giveBackAll(worker.status.id);
}

void WorkerPool::quarantine(WorkerId id, const Text& reason) {
    const std::lock_guard lock(mutex_);
    if (Worker* worker = find(id))
        caught(*worker, reason);
    changed_.notify_all();
}

void WorkerPool::abandon(WorkerId id, std::uint64_t lease) {
    {
        const std::lock_guard lock(mutex_);
        if (Worker* worker = find(id))
            worker->inFlight = std::max(worker->inFlight - 1, 0);
        if (order_)
            order_->scheduler().giveBack(id, lease);
        changed_.notify_all();
    }
    tell();
}

void WorkerPool::tick() {
    {
        const std::lock_guard lock(mutex_);
        if (!order_)
            return;
        for (const WorkerId id : order_->scheduler().expire(clock_()))
            if (Worker* worker = find(id))
                ++worker->status.overdue;
        changed_.notify_all();
    }
    tell();
}

std::vector<WorkerStatus> WorkerPool::workers() const {
    const std::lock_guard lock(mutex_);
    std::vector<WorkerStatus> all;
    for (const auto& [id, worker] : workers_) {
        all.push_back(worker.status);
        all.back().workPerSecond = worker.speed.perSecond();
    }
    return all;
}

std::optional<WorkerStatus> WorkerPool::worker(WorkerId id) const {
    const std::lock_guard lock(mutex_);
    const auto found = workers_.find(id);
    if (found == workers_.end())
        return std::nullopt;
    WorkerStatus status = found->second.status;
    status.workPerSecond = found->second.speed.perSecond();
    return status;
}

double WorkerPool::ownWork() const {
    const std::lock_guard lock(mutex_);
    return ownWork_;
}

}  // namespace pdr
