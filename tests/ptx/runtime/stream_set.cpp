#include "tests/ptx/runtime/stream_set.h"

#include <algorithm>

namespace pdr::ptx {

void Clock::join(const Clock& other) {
    for (std::size_t i = 0; i < ended.size(); ++i)
        ended[i] = std::max(ended[i], other.ended[i]);
}

std::size_t StreamSet::open() {
    waiting_.emplace_back();
    clocks_.push_back(host_);
    return waiting_.size() - 1;
}

std::shared_ptr<Work> StreamSet::add(std::size_t stream, std::string what, std::function<void(const Work&)> run,
                                     std::shared_ptr<Work> after) {
    Clock& clock = clocks_[stream];
    clock.join(host_);
    if (after != nullptr)
        clock.join(after->clock);
    ++clock.of(stream);
    auto work = std::make_shared<Work>(Work{std::move(what), std::move(run), std::move(after), stream, clock});
    waiting_[stream].push_back(work);
    if (order_ == Streams::atOnce)
        finish(work);
    else if (order_ == Streams::atRandom)
        finishSome();
    return work;
}

void StreamSet::finish(const std::shared_ptr<Work>& work) {
    std::deque<std::shared_ptr<Work>>& queue = waiting_[work->stream];
    while (!work->isDone) {
        const std::shared_ptr<Work> next = queue.front();
        if (next->after != nullptr)
            finish(next->after);
        queue.pop_front();
        next->isDone = true;  // also where it fails: nothing is tried twice
        if (next->run)
            next->run(*next);
        next->run = nullptr;
        next->after = nullptr;
    }
}

void StreamSet::finishSome() {
    for (u32 tries = u32(random_() % 4); tries > 0; --tries) {
        const std::deque<std::shared_ptr<Work>>& queue = waiting_[random_() % waiting_.size()];
        if (!queue.empty())
            finish(std::shared_ptr<Work>(queue.front()));
    }
}

void StreamSet::await(const std::shared_ptr<Work>& work) {
    if (work == nullptr)
        return;
    host_.join(work->clock);
    finish(work);
}

void StreamSet::awaitStream(std::size_t stream) {
    host_.join(clocks_[stream]);
    while (!waiting_[stream].empty())
        finish(std::shared_ptr<Work>(waiting_[stream].front()));
}

void StreamSet::awaitAll() {
    for (std::size_t stream = 0; stream < waiting_.size(); ++stream)
        awaitStream(stream);
}

void StreamSet::abandon() {
    for (std::deque<std::shared_ptr<Work>>& queue : waiting_) {
        for (const std::shared_ptr<Work>& work : queue)
            work->isDone = true;
        queue.clear();
    }
}

void StreamSet::touches(const Work& work, u64 name, Extent extent, bool writes) {
    std::vector<Touch>& known = touches_[name];
    for (const Touch& touch : known) {
        const bool meet = touch.extent.low < extent.high && extent.low < touch.extent.high;
        const bool isAfter = work.clock.of(touch.stream) >= touch.clock.of(touch.stream);
        const bool isBefore =
            touch.clock.of(work.stream) >= work.clock.of(work.stream);  // launches are told as they run
        const bool areApart = touch.stream == work.stream || isAfter || isBefore;
        if (meet && !areApart && (touch.writes || writes))
            findings_.tell("streams: " + work.what + (writes ? " writes" : " reads") + " what " + touch.what +
                           (touch.writes ? " writes" : " reads") +
                           " in another stream, and neither waits for the other");
    }
    std::erase_if(known, [&](const Touch& touch) { return touch.clock.of(touch.stream) <= host_.of(touch.stream); });
    known.push_back({work.stream, work.clock, extent, writes, work.what});
}

}  // namespace pdr::ptx
