#include "render/tiles/shared_work.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "render/tiles/pool_state.h"

namespace pdr {
namespace {

/// Polling interval of the own device, and the time after which it returns from that.
constexpr auto kLookAgain = std::chrono::milliseconds(5);
constexpr double kIdleSeconds = 0.2;

SplitFacts factsOf(const PoolState& state, const std::vector<TileGoal>& goals) {
    SplitFacts facts;
    for (const TileGoal& goal : goals) {
        facts.pixels += double(pixelCount(goal.tile));
        facts.samples = std::max(facts.samples, goal.goal - goal.next);
    }
    facts.nodes = state.registry.countTaking(state.scenes.current().number) + (state.own.helps ? 1 : 0);
    facts.nodes = std::max(facts.nodes, 1);
    facts.sampleSeconds = state.times.secondsPerWork();
    facts.launchSeconds = state.times.secondsBefore();
    return facts;
}

}  // namespace

SharedWork::SharedWork(std::shared_ptr<PoolState> state) : state_(std::move(state)) {}
SharedWork::~SharedWork() = default;

std::uint64_t SharedWork::publish(Purpose purpose, std::shared_ptr<const Scene> scene) {
    std::uint64_t number;
    {
        const std::lock_guard lock(state_->mutex);
        number = state_->scenes.publish(purpose, std::move(scene));
        sceneChanged();
    }
    state_->notify();
    return number;
}

void SharedWork::withdraw(std::uint64_t scene) {
    {
        const std::lock_guard lock(state_->mutex);
        if (!state_->scenes.withdraw(scene))
            return;
        sceneChanged();
    }
    state_->notify();
}

void SharedWork::sceneChanged() {
    if (const std::uint64_t current = state_->scenes.current().number; current != state_->checkedScene) {
        state_->checkedScene = current;
        state_->forgetFilm();
    }
    if (state_->request && !state_->isRequestCurrent())
        for (const auto& [id, worker] : state_->registry.all())
            state_->request->giveBackAll(id);
    state_->changed.notify_all();
}

std::size_t SharedWork::countWorkers() const {
    const std::lock_guard lock(state_->mutex);
    return state_->registry.all().size();
}

bool SharedWork::hasWorkers() const {
    const std::lock_guard lock(state_->mutex);
    return state_->registry.hasTrusted();
}

bool SharedWork::isTaken(std::uint64_t scene) const {
    const std::lock_guard lock(state_->mutex);
    return state_->scenes.current().number == scene && state_->registry.countTaking(scene) > 0;
}

bool SharedWork::begin(Film& film, std::uint64_t scene, const std::vector<TileGoal>& goals, const std::stop_token& stop,
                       const Merged& merged) {
    {
        std::unique_lock lock(state_->mutex);
        const auto isServed = [&] { return state_->scenes.current().number == scene; };
        if (!state_->changed.wait(lock, stop, [&] { return !state_->request || !isServed(); }) || !isServed())
            return false;
        state_->split = state_->pinnedSplit ? SplitChoice{*state_->pinnedSplit, "chosen by hand"}
                                            : chooseSplit(factsOf(*state_, goals));
        if (state_->costs.area() != film.area())
            state_->costs = state_->costs.stretchedOver(film.area());
        state_->request =
            std::make_unique<SharedRequest>(film, scene, state_->kept.byKeeper(goals), state_->split.split,
                                            state_->nextLease, state_->costs, merged, state_->unspentProofs);
        for (const auto& [id, worker] : state_->registry.all())
            state_->request->setSuspect(id, worker.isSuspect);
    }
    state_->notify();
    return true;
}

std::optional<SharedWork::OwnWork> SharedWork::nextOwn(const std::stop_token& stop) {
    std::unique_lock lock(state_->mutex);
    SharedRequest& request = *state_->request;
    OwnDevice& own = state_->own;
    const double start = state_->clock();
    while (!request.isDone() && !stop.stop_requested()) {
        own.taken = state_->clock();
        if (std::optional<OwnWork> work = ownWork(request))
            return work;
        if (own.taken - start > kIdleSeconds)
            return OwnWork{};
        state_->changed.wait_for(lock, kLookAgain);
    }
    return std::nullopt;
}

/// Returns first what only the own device can do, so that nobody waits for it; an audit that others may do last.
std::optional<SharedWork::OwnWork> SharedWork::ownWork(SharedRequest& request) {
    const auto isOurs = [&](const Audit& audit) { return !state_->mayAnyCheck(audit); };
    std::optional<Audit> audit = request.audits().takeIf(isOurs);
    if (!audit && (state_->own.helps || !state_->isAnyTaking())) {
        const Ability ability = state_->abilityOf(state_->own.speed, true);
        if (const auto portion = request.scheduler().take(kOwnDevice, ability, state_->own.taken))
            return OwnWork{std::nullopt, request.leaseOf(*portion)};
    }
    if (!audit)
        audit = request.audits().takeLate(state_->own.taken);
    if (!audit)
        return std::nullopt;
    Lease lease = audit->lease;
    return OwnWork{std::move(audit), std::move(lease)};
}

SampleCounts SharedWork::merged() const {
    const std::lock_guard lock(state_->mutex);
    return state_->request->progress().counts();
}

Result<void> SharedWork::deliverOwn(LeaseResult result) {
    {
        const std::lock_guard lock(state_->mutex);
        OwnDevice& own = state_->own;
        const Portion portion{result.number, result.tile, result.samples};
        state_->addTime(kOwnDevice, own.speed, portion, state_->clock() - own.taken, result.seconds);
        if (!state_->request->scheduler().heldBy(kOwnDevice, result.number))
            return {};  // a worker was faster
        if (Result<void> taken = state_->request->take(std::move(result)); !taken)
            return taken;
        state_->kept.took(kOwnDevice, portion.tile, portion.samples);
        own.work += workOf(portion.tile, portion.samples);
    }
    state_->notify();
    return {};
}

Result<void> SharedWork::audited(const Audit& audit, LeaseResult truth) {
    {
        const std::lock_guard lock(state_->mutex);
        if (Result<void> concluded = state_->conclude(audit, std::move(truth)); !concluded)
            return concluded;
    }
    state_->notify();
    return {};
}

NodeChecks SharedWork::checks() const {
    const std::lock_guard lock(state_->mutex);
    return state_->checks;
}

NodeChecks SharedWork::allChecks() const {
    const std::lock_guard lock(state_->mutex);
    NodeChecks all = state_->earlierChecks;
    return all += state_->checks;
}

void SharedWork::discarded() {
    const std::lock_guard lock(state_->mutex);
    state_->forgetFilm();
}

std::set<std::string> SharedWork::end() {
    const std::lock_guard lock(state_->mutex);
    const std::unique_ptr<SharedRequest> ended = std::exchange(state_->request, nullptr);
    state_->nextLease = ended->scheduler().nextNumber();
    state_->unspentProofs = ended->unspent();
    state_->costs.learn(ended->times());
    state_->changed.notify_all();
    return ended->contributors();
}

bool SharedWork::isAnyUntrusted(const std::set<std::string>& keys) const {
    const std::lock_guard lock(state_->mutex);
    return state_->registry.isAnyUntrusted(keys);
}

}  // namespace pdr
