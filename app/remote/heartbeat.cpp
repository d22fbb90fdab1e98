#include "app/remote/heartbeat.h"

#include <algorithm>
#include <vector>

namespace pdr::remote {
namespace {

constexpr std::size_t kOpenPings = 16, kLatencies = 9;

}  // namespace

Heartbeat::Heartbeat(Moment now, const HeartbeatLimits& limits) : limits_(limits), last_(now) {}

/// Counts at most one interval of silence between two calls: if more time has passed, this program was stopped, and
/// data of the peer may wait in the socket.
Heartbeat::Peer Heartbeat::at(Moment now) {
    silence_ += std::min<Moment>(now - last_, limits_.interval);
    last_ = now;
    if (silence_ >= limits_.dead || peer_ == Peer::dead)
        peer_ = Peer::dead;
    else
        peer_ = silence_ >= limits_.suspect ? Peer::suspect : Peer::fine;
    return peer_;
}

void Heartbeat::heard(Moment now) {
    at(now);
    silence_ = Moment{0};
    if (peer_ != Peer::dead)
        peer_ = Peer::fine;
}

std::optional<wire::Ping> Heartbeat::due(Moment now) {
    if (pinged_ && now - *pinged_ < limits_.interval)
        return std::nullopt;
    pinged_ = now;
    open_.push_back({++number_, now});
    if (open_.size() > kOpenPings)
        open_.pop_front();
    return wire::Ping{number_};
}

void Heartbeat::answered(const wire::Pong& pong, Moment now) {
    const auto sent = std::ranges::find(open_, pong.number, &Sent::number);
    if (sent == open_.end())
        return;
    latencies_.push_back(now - sent->when);
    if (latencies_.size() > kLatencies)
        latencies_.pop_front();
    open_.erase(sent);
}

std::optional<Heartbeat::Moment> Heartbeat::latency() const {
    if (latencies_.empty())
        return std::nullopt;
    std::vector<Moment> sorted(latencies_.begin(), latencies_.end());
    const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    return *middle;
}

}  // namespace pdr::remote
