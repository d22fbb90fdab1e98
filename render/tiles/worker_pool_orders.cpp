/// The part of WorkerPool that the device which renders an image calls.

#include <algorithm>
#include <chrono>
#include <utility>

#include "render/tiles/result_check.h"
#include "render/tiles/worker_pool.h"

namespace pdr {
namespace {

/// Polling interval of the own device.
constexpr auto kLookAgain = std::chrono::milliseconds(5);

}  // namespace

std::uint64_t WorkerPool::publish(Purpose purpose, std::shared_ptr<const Scene> scene) {
    std::uint64_t number;
    {
        const std::lock_guard lock(mutex_);
        setPublished(purpose == Purpose::viewport ? viewport_ : finalRender_, std::move(scene));
        number = published_;
    }
    tell();
    return number;
}

void WorkerPool::withdraw(std::uint64_t scene) {
    {
        const std::lock_guard lock(mutex_);
        PublishedScene& published = viewport_.number == scene ? viewport_ : finalRender_;
        if (published.number != scene || !published.scene)
            return;
        setPublished(published, nullptr);
    }
    tell();
}

void WorkerPool::setPublished(PublishedScene& published, std::shared_ptr<const Scene> scene) {
    published.number = ++published_;
    published.scene = std::move(scene);
    if (order_ && !isOrderWanted())
        for (const auto& [id, worker] : workers_)
            order_->scheduler().giveBackAll(id);
    changed_.notify_all();
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
        facts.nodes += worker.takesWork(wanted().number) ? 1 : 0;
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

bool WorkerPool::begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals,
                       const std::stop_token& stop) {
    {
        std::unique_lock lock(mutex_);
        const bool hasComeUp = changed_.wait(lock, stop, [&] { return !order_ || wanted().number != scene; });
        if (!hasComeUp || wanted().number != scene)
            return false;
        split_ = choose(goals);
        if (costs_.area() != film.area())
            costs_ = costs_.stretchedOver(film.area());
        order_ = std::make_unique<SharedOrder>(film, scene, goals, split_.split, nextLease_, costs_);
        believed_.clear();
        for (const auto& [id, worker] : workers_)
            order_->scheduler().setSuspect(id, worker.isSuspect);
    }
    tell();
    return true;
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
        const bool honest = confirms(truth, audit);
        if (worker && honest) {
            worker->trust.passed();
            ++worker->status.audited;
            if (audit.isWithheld)
                worker->count({truth.number, truth.tile, truth.samples});
        } else if (!honest) {
            const Text reason = phrase("a tile of it was not what this machine found when it did it again");
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
    changed_.notify_all();
    return std::exchange(believed_, {});
}

bool WorkerPool::areLiarsAmong(const std::set<std::string>& keys) const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(keys, [&](const std::string& key) { return liars_.contains(key); });
}

}  // namespace pdr
