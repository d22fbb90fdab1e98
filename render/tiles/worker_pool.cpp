#include "render/tiles/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pdr {
namespace {

/// Of what is left to do, a worker gets so much of its fair share at a time: the last portions are small then, and all
/// end together (guided self-scheduling, Polychronopoulos & Kuck 1987).
constexpr double kShare = 0.4;
/// What somebody gets of whom nothing is known: some cells.
constexpr double kFirstCost = 16 * kFilmCell * kFilmCell;
/// The own device looks so often whether there is something new for it.
constexpr auto kLookAgain = std::chrono::milliseconds(5);

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
                               Past{worker->trust, worker->isQuarantined() ? worker->status.reason : ""});
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
    return scene_;
}

void WorkerPool::hasScene(WorkerId id, std::uint64_t scene) {
    const std::lock_guard lock(mutex_);
    if (Worker* worker = find(id)) {
        worker->scene = scene;
        worker->inFlight = 0;
        worker->status.reason.clear();
        worker->updateState();
    }
}

void WorkerPool::cannotTakeScene(WorkerId id, const std::string& reason) {
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
        if (worker.takesWork(scene_.number))
            all += worker.speed.perSecond();
    const double mine = speed.perSecond();
    if (mine <= 0)  // let it be as fast as the own device, for what it is expected to take
        return {kFirstCost, std::max(ownSpeed_.perSecond(), kFirstCost)};
    const double fair = order_->scheduler().openCost() * mine / std::max(all, mine) * kShare;
    const double longest = isOnProbation ? kProbationSeconds : costs_.isKnown() ? kLongestSeconds : kUnknownSeconds;
    return {std::clamp(fair, mine * kShortestSeconds, mine * longest), mine};
}

bool WorkerPool::anyTakesWork() const {
    return std::ranges::any_of(workers_, [&](const auto& one) { return one.second.takesWork(scene_.number); });
}

std::optional<Lease> WorkerPool::take(WorkerId id) {
    const std::lock_guard lock(mutex_);
    Worker* worker = find(id);
    if (!order_ || !worker || !worker->takesWork(order_->scene()))
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
        } else if (result.tile != portion->tile || result.samples != portion->samples) {
            caught(*worker, "it sent a tile that it was not asked for");
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

void WorkerPool::caught(Worker& worker, const std::string& reason) {
    if (!worker.isQuarantined()) {
        worker.status.state = WorkerState::quarantined;
        worker.status.reason = reason;
    }
    liars_.insert(worker.status.key);
    if (order_)
        order_->scheduler().giveBackAll(worker.status.id);
}

void WorkerPool::quarantine(WorkerId id, const std::string& reason) {
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
        const std::vector<WorkerId> late = order_->scheduler().expire(clock_());
        for (const WorkerId id : late)
            if (Worker* worker = find(id)) {
                ++worker->status.overdue;
                worker->inFlight = std::max(worker->inFlight - 1, 0);
            }
        changed_.notify_all();
    }
    tell();
}

std::uint64_t WorkerPool::publish(std::shared_ptr<const Scene> scene) {
    std::uint64_t number;
    {
        const std::lock_guard lock(mutex_);
        number = scene_.number + 1;
        scene_ = {number, std::move(scene)};
    }
    tell();
    return number;
}

void WorkerPool::forgetScene() {
    publish(nullptr);
}

void WorkerPool::setSplit(std::optional<Split> split) {
    const std::lock_guard lock(mutex_);
    pinned_ = split;
}

SplitChoice WorkerPool::split() const {
    const std::lock_guard lock(mutex_);
    return split_;
}

SplitChoice WorkerPool::choose(const std::vector<TileGoal>& goals) const {
    if (pinned_)
        return {*pinned_, "chosen by hand"};
    SplitFacts facts;
    for (const TileGoal& goal : goals) {
        facts.pixels += double(goal.tile.width) * goal.tile.height;
        facts.samples = std::max(facts.samples, goal.goal - goal.next);
    }
    facts.nodes = ownHelps_ ? 1 : 0;
    for (const auto& [id, worker] : workers_)
        facts.nodes += worker.takesWork(scene_.number) ? 1 : 0;
    facts.nodes = std::max(facts.nodes, 1);
    facts.sampleSeconds = times_.secondsPerWork();
    facts.launchSeconds = times_.secondsBefore();
    return chooseSplit(facts);
}

bool WorkerPool::hasWorkers() const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(workers_, [](const auto& one) { return !one.second.isQuarantined(); });
}

void WorkerPool::setOwnHelps(bool helps) {
    const std::lock_guard lock(mutex_);
    ownHelps_ = helps;
}

void WorkerPool::begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals) {
    {
        const std::lock_guard lock(mutex_);
        split_ = choose(goals);
        if (costs_.area() != film.area())
            costs_ = costs_.stretchedOver(film.area());
        order_ = std::make_unique<SharedOrder>(film, scene, goals, split_.split, nextLease_, costs_);
        believed_.clear();
        for (auto& [id, worker] : workers_) {
            worker.inFlight = 0;
            order_->scheduler().setSuspect(id, worker.isSuspect);
        }
    }
    tell();
}

std::optional<WorkerPool::OwnWork> WorkerPool::nextOwn(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!order_->isDone() && !stop.stop_requested()) {
        if (std::optional<Audit> audit = order_->nextAudit()) {
            const Lease lease = audit->lease;
            return OwnWork{std::move(audit), lease};
        }
        ownTaken_ = clock_();
        if (ownHelps_ || !anyTakesWork()) {
            const Ability ability = abilityOf(ownSpeed_, false);
            if (const auto portion = order_->scheduler().take(kOwnDevice, ability, ownTaken_))
                return OwnWork{std::nullopt, order_->leaseOf(*portion)};
        }
        changed_.wait_for(lock, kLookAgain);
    }
    return std::nullopt;
}

Result<void> WorkerPool::deliverOwn(LeaseResult result) {
    {
        const std::lock_guard lock(mutex_);
        const Portion portion{result.number, result.tile, result.samples};
        timed(kOwnDevice, ownSpeed_, portion, clock_() - ownTaken_, result.seconds);
        if (!order_->scheduler().heldBy(kOwnDevice, result.number))
            return {};  // a worker was faster
        if (Result<void> taken = order_->take(std::move(result)); !taken)
            return taken;
        ownWork_ += workOf(portion.tile, portion.samples);
    }
    tell();
    return {};
}

Result<void> WorkerPool::audited(const Audit& audit, LeaseResult truth) {
    {
        const std::lock_guard lock(mutex_);
        Worker* worker = find(audit.worker);
        const bool honest = sameBits(audit.claimed.sums, truth.sums);
        if (worker && honest) {
            worker->trust.passed();
            ++worker->status.audited;
            if (audit.isWithheld)
                worker->count({truth.number, truth.tile, truth.samples});
        } else if (!honest) {
            const std::string reason = "a tile of it was not what this machine found when it did it again";
            if (worker)
                caught(*worker, reason);
            liars_.insert(audit.key);
            if (const auto past = past_.find(audit.key); past != past_.end())
                past->second.quarantine = reason;
        }
        if (!audit.isWithheld)
            return {};
        truth.number = audit.claimed.number;
        if (Result<void> taken = order_->take(std::move(truth)); !taken)
            return taken;
    }
    tell();
    return {};
}

std::set<std::string> WorkerPool::end() {
    const std::lock_guard lock(mutex_);
    nextLease_ = order_->scheduler().nextNumber();
    costs_.learn(std::exchange(timed_, {}));
    order_.reset();
    return std::exchange(believed_, {});
}

bool WorkerPool::areLiarsAmong(const std::set<std::string>& keys) const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(keys, [&](const std::string& key) { return liars_.contains(key); });
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
