#include "render/tiles/tile_scheduler.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace pdr {
namespace {

/// Merges two adjacent tiles into `a`; false: their union is no rectangle.
bool join(Tile& a, const Tile& b) {
    if (a.x == b.x && a.width == b.width && (a.y + a.height == b.y || b.y + b.height == a.y)) {
        a = {a.x, std::min(a.y, b.y), a.width, a.height + b.height};
        return true;
    }
    if (a.y == b.y && a.height == b.height && (a.x + a.width == b.x || b.x + b.width == a.x)) {
        a = {std::min(a.x, b.x), a.y, a.width + b.width, a.height};
        return true;
    }
    return false;
}

/// Grows a side of a tile by whole cells, up to `most`, as long as isTooMuch() is false.
void grow(int& side, int most, const std::function<bool()>& isTooMuch) {
    while (side < most) {
        const int before = side;
        side = std::min(side + kFilmCell, most);
        if (isTooMuch()) {
            side = before;
            return;
        }
    }
}

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// Returns the first cell of a tile.
Tile firstCell(const Tile& tile) {
    return {tile.x, tile.y, std::min(tile.width, kFilmCell), std::min(tile.height, kFilmCell)};
}

}  // namespace

TileScheduler::TileScheduler(const std::vector<TileGoal>& goals, Split split, std::uint64_t firstNumber,
                             CellCosts costs)
    : split_(split), number_(firstNumber), costs_(std::move(costs)) {
    for (const TileGoal& goal : goals)
        if (goal.next < goal.goal)
            open_.push_back(goal);
}

std::optional<Portion> TileScheduler::take(WorkerId worker, const Ability& ability, double now) {
    if (std::optional<Portion> portion = cut(worker, ability, now))
        return portion;
    return hedge(worker, ability, now);
}

std::optional<Portion> TileScheduler::cut(WorkerId worker, const Ability& ability, double now) {
    if (open_.empty())
        return std::nullopt;
    // Cut a tile from an open goal and put the rest back
    const auto open = openFor(worker);
    const TileGoal from = *open;
    const SampleRange samples = nextSamples(from, ability);
    if (costs_.ofSample(firstCell(from.tile)) * samples.count > ability.most)
        return std::nullopt;
    auto rest = open_.erase(open);
    const bool isCut = split_ == Split::tiles || ability.isLimited();
    const double cost = isCut ? std::min(ability.cost, ability.most) : kUnlimited;
    const Tile tile = part(from.tile, cost / samples.count, isDeep(samples) ? kMostDeepPixels : kMostLeasePixels);
    const Tile& all = from.tile;
    const int right = all.x + all.width - (tile.x + tile.width), below = all.y + all.height - (tile.y + tile.height);
    if (below > 0)
        rest = open_.insert(rest, {{all.x, tile.y + tile.height, all.width, below}, from.next, from.goal, from.keeper});
    if (right > 0)
        open_.insert(rest, {{tile.x + tile.width, tile.y, right, tile.height}, from.next, from.goal, from.keeper});
    const Portion portion{number_++, tile, samples};
    // Blocks are independent: the next one need not wait for this one.
    const bool follows = split_ == Split::samples && samples.end() < from.goal;
    if (follows)
        free({tile, samples.end(), from.goal}, false);
    held_.push_back({portion, from.goal, {copyFor(worker, portion, ability, now)}, follows});
    return portion;
}

/// Returns the first open goal that is meant for the worker; else the first that is meant for nobody; else the last
/// one, which its keeper would come to last.
std::deque<TileGoal>::iterator TileScheduler::openFor(WorkerId worker) {
    for (const WorkerId keeper : {worker, kOwnDevice})
        if (const auto found = std::ranges::find(open_, keeper, &TileGoal::keeper); found != open_.end())
            return found;
    return std::prev(open_.end());
}

/// Returns the samples of the next portion of a goal: as many whole blocks as are left, since what comes back is as
/// long as that of one block; else those of one block, or the part of it that a limited portion may have. Tiles are cut
/// small rather than into few blocks, but a cell must not take too long. Blocks that are split among workers come back
/// one by one.
SampleRange TileScheduler::nextSamples(const TileGoal& goal, const Ability& ability) const {
    const std::uint64_t left = goal.goal - goal.next;
    const SampleRange inBlock =
        samplesInBlock(goal.next, std::uint32_t(std::min<std::uint64_t>(left, kSamplesPerBlock)));
    if (split_ != Split::tiles)
        return inBlock;
    const double cell = costs_.ofSample(firstCell(goal.tile));
    if (ability.isLimited())
        return {goal.next,
                std::uint32_t(std::clamp(std::min(ability.cost, ability.most) / cell, 1.0, double(inBlock.count)))};
    if (goal.next % kSamplesPerBlock != 0)
        return inBlock;
    const double most = std::min(ability.deepest / cell, double(kMostDeepSamples));
    const std::uint64_t blocks = std::min(left, std::uint64_t(most)) / kSamplesPerBlock;
    return blocks > 1 ? SampleRange{goal.next, std::uint32_t(blocks * kSamplesPerBlock)} : inBlock;
}

/// Returns the top rows of cells or, if one row is too much, the left part of it: up to that cost and number of pixels,
/// but at least one cell.
Tile TileScheduler::part(const Tile& tile, double cost, std::size_t mostPixels) const {
    const auto isTooMuch = [&](const Tile& some) {
        return pixelCount(some) > mostPixels || costs_.ofSample(some) > cost;
    };
    Tile rows{tile.x, tile.y, tile.width, std::min(tile.height, kFilmCell)};
    if (isTooMuch(rows)) {
        Tile cells{tile.x, tile.y, std::min(tile.width, kFilmCell), rows.height};
        grow(cells.width, tile.width, [&] { return isTooMuch(cells); });
        return cells;
    }
    grow(rows.height, tile.height, [&] { return isTooMuch(rows); });
    return rows;
}

std::optional<Portion> TileScheduler::hedge(WorkerId worker, const Ability& ability, double now) {
    Held* latest = nullptr;
    for (Held& held : held_) {
        const bool his = std::ranges::any_of(held.copies, [&](const Copy& copy) { return copy.worker == worker; });
        const bool canTake =
            (ability.deepest > 0 || !isDeep(held.portion.samples)) && costOf(held.portion) <= ability.most;
        if (!his && canTake && isLate(held, worker, now) && (!latest || held.copies[0].since < latest->copies[0].since))
            latest = &held;
    }
    if (!latest)
        return std::nullopt;
    latest->copies.push_back(copyFor(worker, latest->portion, ability, now));
    return latest->portion;
}

bool TileScheduler::isLate(const Held& held, WorkerId whoAsks, double now) const {
    return !held.arrived && std::ranges::all_of(held.copies, [&](const Copy& copy) {
        const double patience =
            whoAsks == kOwnDevice ? copy.expectedSeconds + kOwnHedgeSeconds : 3 * copy.expectedSeconds + kHedgeSeconds;
        return suspects_.contains(copy.worker) || now - copy.since > patience;
    });
}

double TileScheduler::costHeldBy(WorkerId worker) const {
    double cost = 0;
    for (const Held& held : held_)
        for (const Copy& copy : held.copies)
            if (copy.worker == worker && !held.arrived)
                cost += costOf(held.portion);
    return cost;
}

TileScheduler::Copy TileScheduler::copyFor(WorkerId worker, const Portion& portion, const Ability& ability,
                                           double now) const {
    return {worker, now, (costHeldBy(worker) + costOf(portion)) / ability.perSecond};
}

std::optional<Portion> TileScheduler::heldBy(WorkerId worker, std::uint64_t number) const {
    for (const Held& held : held_)
        if (held.portion.number == number && !held.arrived)
            for (const Copy& copy : held.copies)
                if (copy.worker == worker)
                    return held.portion;
    return std::nullopt;
}

std::vector<TileScheduler::Held>::iterator TileScheduler::find(std::uint64_t number) {
    return std::ranges::find_if(held_, [&](const Held& held) { return held.portion.number == number; });
}

void TileScheduler::arrived(std::uint64_t number) {
    if (const auto held = find(number); held != held_.end())
        held->arrived = true;
}

void TileScheduler::finish(std::uint64_t number) {
    const auto held = find(number);
    if (held == held_.end())
        return;
    const TileGoal rest{held->portion.tile, held->portion.samples.end(), held->goal};
    const bool follows = !held->followed && rest.next < rest.goal;
    held_.erase(held);
    if (follows)
        free(rest, false);
}

void TileScheduler::free(const TileGoal& goal, bool first) {
    for (TileGoal& open : open_)
        if (open.next == goal.next && open.goal == goal.goal && open.keeper == goal.keeper &&
            join(open.tile, goal.tile))
            return;
    if (first)
        open_.push_front(goal);
    else
        open_.push_back(goal);
}

void TileScheduler::drop(Held& held, WorkerId worker) {
    if (!held.arrived)
        std::erase_if(held.copies, [&](const Copy& copy) { return copy.worker == worker; });
}

/// Reopens portions that no worker has any more; only their own block if the next one is available already.
void TileScheduler::removeFreed() {
    for (const Held& held : held_)
        if (held.copies.empty())
            free(
                {held.portion.tile, held.portion.samples.first, held.followed ? held.portion.samples.end() : held.goal},
                true);
    std::erase_if(held_, [](const Held& held) { return held.copies.empty(); });
}

void TileScheduler::giveBack(WorkerId worker, std::uint64_t number) {
    if (const auto held = find(number); held != held_.end())
        drop(*held, worker);
    removeFreed();
}

void TileScheduler::giveBackAll(WorkerId worker) {
    suspects_.erase(worker);
    for (Held& held : held_)
        drop(held, worker);
    removeFreed();
}

void TileScheduler::setSuspect(WorkerId worker, bool suspect) {
    if (suspect)
        suspects_.insert(worker);
    else
        suspects_.erase(worker);
}

std::vector<WorkerId> TileScheduler::expire(double now) {
    std::vector<WorkerId> late;
    for (Held& held : held_)
        if (!held.arrived)
            std::erase_if(held.copies, [&](const Copy& copy) {
                const bool isOver =
                    copy.worker != kOwnDevice && now - copy.since > 4 * copy.expectedSeconds + kExpirySeconds;
                if (isOver)
                    late.push_back(copy.worker);
                return isOver;
            });
    removeFreed();
    return late;
}

double TileScheduler::leastCost() const {
    if (open_.empty())
        return 0;
    // As openFor() has it for a worker that has rendered nothing yet
    const auto nobodys = std::ranges::find(open_, kOwnDevice, &TileGoal::keeper);
    const TileGoal& next = nobodys != open_.end() ? *nobodys : open_.back();
    return costs_.ofSample(firstCell(next.tile)) * nextSamples(next, {.most = 0}).count;
}

double TileScheduler::openCost() const {
    double cost = 0;
    for (const TileGoal& goal : open_)
        cost += costs_.ofSample(goal.tile) * double(goal.goal - goal.next);
    return cost;
}

}  // namespace pdr
