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
        state_->kept.forget(id);
        if (state_->request)
            state_->request->giveBackAll(id);
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
            state_->request->setSuspect(id, suspect);
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
    if (worker->inFlight >= (worker->trust.isProved() ? kInFlight : 1))
        return std::nullopt;
    const double now = state_->clock();
    std::optional<Lease> lease = state_->leaseFor(*worker, now);
    if (lease && worker->inFlight++ == 0)
        worker->lastResult = now;
    return lease;
}

void LeaseServer::deliver(WorkerId id, LeaseResult result) {
    {
        const std::lock_guard lock(state_->mutex);
        Worker* worker = state_->registry.find(id);
        if (!worker)
            return;
        worker->inFlight = std::max(worker->inFlight - 1, 0);
        std::optional<Portion> portion;
        std::optional<Audit> audit;
        if (state_->request) {
            portion = state_->request->scheduler().heldBy(id, result.number);
            audit = state_->request->audits().takeFrom(id, result.number);
        }
        if (portion)
            accept(*worker, *portion, std::move(result));
        else if (audit)
            check(*worker, *std::move(audit), std::move(result));
        else
            late(*worker);
        state_->changed.notify_all();
    }
    state_->notify();
}

void LeaseServer::late(Worker& worker) {
    ++worker.status.late;
    worker.lastResult = state_->clock();
}

void LeaseServer::measure(Worker& worker, const Portion& portion, const LeaseResult& result) {
    const double now = state_->clock(), seconds = now - worker.lastResult;
    state_->addTime(worker.status.id, worker.speed, portion, seconds, result.seconds);
    state_->times.add(workOf(result.tile, result.samples), seconds);
    worker.lastResult = now;
    worker.status.busySeconds += result.seconds;
}

void LeaseServer::accept(Worker& worker, const Portion& portion, LeaseResult result) {
    const int imageWidth = state_->scenes.current().scene->film.x;
    if (const std::string why = whatIsImpossible(result, portion, imageWidth); !why.empty())
        return state_->quarantine(worker.status.key, why);
    measure(worker, portion, result);
    if (state_->checksAll || state_->request->isProof(portion.number))
        state_->request->withhold(worker, portion, std::move(result));
    else
        merge(worker, portion, std::move(result));
}

void LeaseServer::merge(Worker& worker, const Portion& portion, LeaseResult result) {
    SharedRequest& request = *state_->request;
    if (const std::optional<Tile> part = worker.trust.partToAudit(result.tile))
        request.auditPart(worker, result, *part);
    if (Result<void> taken = request.take(std::move(result)); !taken)
        return state_->quarantine(worker.status.key, taken.error().what);
    state_->kept.took(worker.status.id, portion.tile, portion.samples);
    request.addContributor(worker.status.key);
    state_->count(&worker, portion);
}

void LeaseServer::check(Worker& worker, Audit audit, LeaseResult result) {
    const Portion portion{audit.lease.number, audit.lease.tile, audit.lease.samples};
    const int imageWidth = state_->scenes.current().scene->film.x;
    if (const std::string why = whatIsImpossible(result, portion, imageWidth); !why.empty()) {
        state_->request->audits().add(std::move(audit));
        return state_->quarantine(worker.status.key, why);
    }
    measure(worker, portion, result);
    if (confirms(result, audit) && state_->conclude(audit, result))
        return;
    audit.second = Audit::Opinion{worker.status.key, std::move(result)};
    state_->request->audits().add(std::move(audit));
}

void LeaseServer::abandon(WorkerId id, std::uint64_t lease) {
    {
        const std::lock_guard lock(state_->mutex);
        if (Worker* worker = state_->registry.find(id))
            worker->inFlight = std::max(worker->inFlight - 1, 0);
        state_->kept.forget(id);  // what it has lost is sent with the next lease
        if (state_->request)
            state_->request->giveBack(id, lease);
        state_->changed.notify_all();
    }
    state_->notify();
}

void LeaseServer::tick() {
    {
        const std::lock_guard lock(state_->mutex);
        if (!state_->request)
            return;
        for (const WorkerId id : state_->request->expire(state_->clock()))
            if (Worker* worker = state_->registry.find(id))
                ++worker->status.overdue;
        state_->changed.notify_all();
    }
    state_->notify();
}

}  // namespace pdr
