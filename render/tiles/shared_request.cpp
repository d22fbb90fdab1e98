#include "render/tiles/shared_request.h"

#include <algorithm>
#include <utility>

namespace pdr {
namespace {

/// Returns the values of the pixels of `part`; none if the tile `all` has none.
template <class Pixel>
std::vector<Pixel> partOf(const std::vector<Pixel>& pixels, const Tile& all, const Tile& part) {
    std::vector<Pixel> some;
    if (pixels.empty())
        return some;
    some.reserve(pixelCount(part));
    for (int y = part.y; y < part.y + part.height; ++y) {
        const auto row = pixels.begin() + std::ptrdiff_t(y - all.y) * all.width + (part.x - all.x);
        some.insert(some.end(), row, row + part.width);
    }
    return some;
}

}  // namespace

Lease SharedRequest::leaseOf(const Portion& portion) const {
    Lease lease{portion.number, scene_, portion.tile, portion.samples, {}, {}};
    const Tile& tile = portion.tile;
    if (isDeep(portion.samples))
        lease.moments = film_.fullBlocks(tile);
    if (portion.samples.first % kSamplesPerBlock == 0)
        return lease;
    const TileSums here = film_.sums(tile);
    lease.before.reserve(pixelCount(tile));
    for (int y = 0; y < tile.height; ++y) {
        const PixelSums* row = here.pixels + std::ptrdiff_t(y) * here.stride;
        lease.before.insert(lease.before.end(), row, row + tile.width);
    }
    return lease;
}

Result<void> SharedRequest::take(LeaseResult result) {
    const std::uint64_t number = result.number;
    if (!isNext(result)) {
        early_.push_back(std::move(result));
        scheduler_.finish(number);
        return {};
    }
    if (Result<void> merged = merge(std::move(result)); !merged)
        return merged;
    scheduler_.finish(number);
    for (auto next = early_.begin(); next != early_.end();) {
        if (!isNext(*next)) {
            ++next;
            continue;
        }
        LeaseResult one = std::move(*next);
        early_.erase(next);
        if (Result<void> merged = merge(std::move(one)); !merged)
            return merged;
        next = early_.begin();
    }
    return {};
}

bool SharedRequest::isNext(const LeaseResult& result) const {
    const std::vector<EvenTile> here = film_.progress().evenTiles(result.tile);
    return here.size() == 1 && here[0].next == result.samples.first;
}

Result<void> SharedRequest::merge(LeaseResult result) {
    if (merged_)
        merged_(result);
    // A film that began within a block has none of the block's earlier samples.
    const SampleRange block = fromBlockStart(result.samples);
    const std::uint64_t first = std::max(block.first, film_.progress().first());
    const SampleRange samples{first, std::uint32_t(block.end() - first)};
    return film_.merge(
        {film_.revision(), result.tile, samples, std::move(result.sums), result.health, std::move(result.moments)});
}

std::optional<Portion> SharedRequest::takeProof(WorkerId worker, const Ability& ability, double now) {
    if (audits_.countOf(worker) >= kMostProofs)
        return std::nullopt;
    const Ability small{std::min(ability.cost, kProofCost), ability.perSecond, 0, proofCost_};
    const std::optional<Portion> portion = scheduler_.take(worker, small, now);
    if (portion) {
        proofCost_ -= scheduler_.costOf(*portion);
        proofs_.insert(portion->number);
    }
    return portion;
}

Audit SharedRequest::auditOf(const Worker& worker, LeaseResult claimed) {
    const Portion again{scheduler_.newNumber(), claimed.tile, claimed.samples};
    Audit audit{worker.status.id, worker.status.key, std::move(claimed), leaseOf(again), scheduler_.costOf(again)};
    audit.isProof = !worker.trust.isProved();
    return audit;
}

void SharedRequest::withhold(const Worker& worker, const Portion& portion, LeaseResult result) {
    scheduler_.arrived(portion.number);
    Audit audit = auditOf(worker, std::move(result));
    audit.isWithheld = true;
    audits_.add(std::move(audit));
}

void SharedRequest::auditPart(const Worker& worker, const LeaseResult& result, const Tile& part) {
    if (audits_.countOf(worker.status.id) >= kMostAudits)
        return;
    LeaseResult claimed{result.number,
                        part,
                        result.samples,
                        partOf(result.sums, result.tile, part),
                        result.health,
                        0,
                        partOf(result.moments, result.tile, part)};
    audits_.add(auditOf(worker, std::move(claimed)));
}

void SharedRequest::giveBack(WorkerId worker, std::uint64_t number) {
    scheduler_.giveBack(worker, number);
    audits_.giveBack(worker, number);
}

void SharedRequest::giveBackAll(WorkerId worker) {
    scheduler_.giveBackAll(worker);
    audits_.giveBackAll(worker);
}

void SharedRequest::setSuspect(WorkerId worker, bool suspect) {
    scheduler_.setSuspect(worker, suspect);
    if (suspect)
        audits_.giveBackAll(worker);
}

std::vector<WorkerId> SharedRequest::expire(double now) {
    std::vector<WorkerId> late = scheduler_.expire(now);
    for (const WorkerId worker : audits_.expire(now))
        late.push_back(worker);
    return late;
}

}  // namespace pdr
