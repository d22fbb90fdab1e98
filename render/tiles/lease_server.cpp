#include "render/tiles/lease_server.h"

#include <algorithm>
#include <utility>

#include "render/tiles/pool_state.h"
#include "render/tiles/result_check.h"

namespace pdr {

LeaseServer::LeaseServer(std::shared_ptr<PoolState> state) : state_(std::move(state)) {}
LeaseServer::~LeaseServer() = default;

void LeaseServer::setNotice(std::function<void()> notice) {
    state_->setNotice(std::move(notice));
}

WorkerId LeaseServer::join(const std::string& key, const std::string& name, bool isDeep) {
    const std::lock_guard lock(state_->mutex);
    const WorkerId id = state_->registry.join(key, name);
    state_->registry.find(id)->status.isDeep = isDeep;
    return id;
}

void LeaseServer::leave(WorkerId id) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->registry.leave(id);
        if (state_->request)
            state_->request->scheduler().giveBackAll(id);
        state_->changed.notify_all();
    }
    state_->notify();
}

std::optional<WorkerStatus> LeaseServer::status(WorkerId id) const {
    const std::lock_guard lock(state_->mutex);
    const Worker* worker = state_->registry.find(id);
    return worker ? std::optional(worker->statusNow()) : std::nullopt;
}

void LeaseServer::setSuspect(WorkerId id, bool suspect) {
    {
        const std::lock_guard lock(state_->mutex);
        Worker* worker = state_->registry.find(id);
        if (!worker || worker->isSuspect == suspect)
            return;
        worker->isSuspect = suspect;
        worker->updateState();
        if (state_->request)
            state_->request->scheduler().setSuspect(id, suspect);
        state_->changed.notify_all();
    }
    state_->notify();
}

void LeaseServer::setPaused(WorkerId id, bool paused) {
    {
        const std::lock_guard lock(state_->mutex);
        if (Worker* worker = state_->registry.find(id)) {
            worker->isPaused = paused;
            worker->updateState();
        }
    }
    state_->notify();
}

void LeaseServer::setDraining(WorkerId id) {
    const std::lock_guard lock(state_->mutex);
    if (Worker* worker = state_->registry.find(id)) {
        worker->isDraining = true;
        worker->updateState();
    }
}

void LeaseServer::quarantine(WorkerId id, const Text& reason) {
    const std::lock_guard lock(state_->mutex);
    if (const Worker* worker = state_->registry.find(id))
        state_->quarantine(worker->status.key, reason);
    state_->changed.notify_all();
}

PublishedScene LeaseServer::scene() const {
    const std::lock_guard lock(state_->mutex);
    return state_->scenes.current();
}

void LeaseServer::hasScene(WorkerId id, std::uint64_t scene) {
    const std::lock_guard lock(state_->mutex);
    if (Worker* worker = state_->registry.find(id)) {
        worker->scene = scene;
        worker->inFlight = 0;
        worker->status.reason = {};
        worker->updateState();
    }
}

void LeaseServer::cannotTakeScene(WorkerId id, const Text& reason) {
    const std::lock_guard lock(state_->mutex);
    if (Worker* worker = state_->registry.find(id)) {
        worker->scene = 0;
        worker->status.reason = reason;
        worker->updateState();
    }
}

std::optional<Lease> LeaseServer::take(WorkerId id) {
    const std::lock_guard lock(state_->mutex);
    Worker* worker = state_->registry.find(id);
    if (!state_->isRequestCurrent() || !worker || !worker->takesWork(state_->request->scene()))
        return std::nullopt;
    const bool probation = worker->trust.isOnProbation();
    if (worker->inFlight >= (probation ? 1 : kInFlight))
        return std::nullopt;
    const double now = state_->clock();
    const Ability ability = state_->abilityOf(worker->speed, probation, worker->status.isDeep);
    const std::optional<Portion> portion = state_->request->scheduler().take(id, ability, now);
    if (!portion)
        return std::nullopt;
    if (worker->inFlight++ == 0)
        worker->lastResult = now;
    return state_->request->leaseOf(*portion);
}

void LeaseServer::deliver(WorkerId id, LeaseResult result) {
    {
        const std::lock_guard lock(state_->mutex);
        Worker* worker = state_->registry.find(id);
        if (!worker)
            return;
        worker->inFlight = std::max(worker->inFlight - 1, 0);
        const std::optional<Portion> portion =
            state_->request ? state_->request->scheduler().heldBy(id, result.number) : std::nullopt;
        if (portion) {
            accept(*worker, *portion, std::move(result));
        } else {
            ++worker->status.late;
            worker->lastResult = state_->clock();
        }
        state_->changed.notify_all();
    }
    state_->notify();
}

void LeaseServer::accept(Worker& worker, const Portion& portion, LeaseResult result) {
    const int imageWidth = state_->scenes.current().scene->film.x;
    if (const std::string why = whatIsImpossible(result, portion, imageWidth); !why.empty())
        return state_->quarantine(worker.status.key, why);
    // Measure the worker
    const double now = state_->clock(), seconds = now - worker.lastResult;
    state_->addTime(worker.status.id, worker.speed, portion, seconds, result.seconds);
    state_->times.add(workOf(result.tile, result.samples), seconds);
    worker.lastResult = now;
    worker.status.busySeconds += result.seconds;
    // Merge the result, now or after its audit
    if (worker.trust.isOnProbation())
        state_->request->withhold(worker.status, portion, std::move(result));
    else
        merge(worker, portion, std::move(result));
}

void LeaseServer::merge(Worker& worker, const Portion& portion, LeaseResult result) {
    SharedRequest& request = *state_->request;
    if (const std::optional<Tile> part = worker.trust.partToAudit(result.tile))
        request.auditPart(worker.status, portion, result, *part);
    if (Result<void> taken = request.take(std::move(result)); !taken)
        return state_->quarantine(worker.status.key, taken.error().what);
    request.addContributor(worker.status.key);
    worker.count(portion);
}

void LeaseServer::abandon(WorkerId id, std::uint64_t lease) {
    {
        const std::lock_guard lock(state_->mutex);
        if (Worker* worker = state_->registry.find(id))
            worker->inFlight = std::max(worker->inFlight - 1, 0);
        if (state_->request)
            state_->request->scheduler().giveBack(id, lease);
        state_->changed.notify_all();
    }
    state_->notify();
}

void LeaseServer::tick() {
    {
        const std::lock_guard lock(state_->mutex);
        if (!state_->request)
            return;
        for (const WorkerId id : state_->request->scheduler().expire(state_->clock()))
            if (Worker* worker = state_->registry.find(id))
                ++worker->status.overdue;
        state_->changed.notify_all();
    }
    state_->notify();
}

}  // namespace pdr
