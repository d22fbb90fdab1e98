#include "app/node/node_seats.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/node/node_session.h"

namespace pdr::node {
namespace {

/// Time for which a seat is kept after a connection was lost, in case the coordinator comes back.
constexpr std::chrono::seconds kMemory(60);
/// Time between two looks for idle seats.
constexpr std::chrono::seconds kLook(5);

}  // namespace

NodeSeats::NodeSeats(int most, OpenDevice open, FairTurns::Clock clock, std::function<std::uint64_t()> freeMemory,
                     std::function<std::chrono::microseconds()> now, QObject* parent)
    : QObject(parent),
      most_(std::size_t(most)),
      open_(std::move(open)),
      turns_(std::move(clock)),
      freeMemory_(std::move(freeMemory)),
      now_(std::move(now)) {
    connect(&look_, &QTimer::timeout, this, &NodeSeats::advance);
}

NodeSeats::~NodeSeats() = default;

NodeSeats::Taken* NodeSeats::seatOf(const NodeSession& session) {
    const auto found = std::ranges::find(taken_, &session, &Taken::session);
    return found == taken_.end() ? nullptr : &*found;
}

/// False: it was not in the line.
bool NodeSeats::leaveLine(const NodeSession& session) {
    return std::erase_if(line_, [&](const Waiting& one) { return one.session == &session; }) > 0;
}

void NodeSeats::ask(NodeSession& session) {
    if (sitAgain(session))
        return;
    std::erase_if(taken_, [](const Taken& one) { return !one.session; });
    if (taken_.size() < most_)
        return open(session);
    const auto place = std::ranges::find(line_, &session, &Waiting::session);
    if (place == line_.end() || place->isIdle) {
        leaveLine(session);
        line_.insert(std::ranges::find(line_, true, &Waiting::isIdle), {&session});
    }
    advance();
}

void NodeSeats::worked(const NodeSession& session) {
    if (Taken* seat = seatOf(session))
        seat->worked = now_();
}

bool NodeSeats::isIdle(const Taken& seat) const {
    return seat.session && !seat.session->isBusy() && now_() - seat.worked > kIdle;
}

/// Takes idle seats back, as many as there are others who have work.
void NodeSeats::freeIdle() {
    auto wanting = std::ranges::count(line_, false, &Waiting::isIdle);
    for (auto seat = taken_.begin(); seat != taken_.end() && wanting > 0 && taken_.size() >= most_;) {
        if (!isIdle(*seat)) {
            ++seat;
            continue;
        }
        seat->session->rise();
        line_.push_back({seat->session, true});
        seat = taken_.erase(seat);
        --wanting;
    }
}

/// Gives `session` the seat that its coordinator, which alone knows the key, had before it lost its connection.
bool NodeSeats::sitAgain(NodeSession& session) {
    for (Taken& one : taken_)
        if (!one.session && one.seat.contents.key() == session.key()) {
            one.session = &session;
            one.forgotten.reset();
            session.sit(one.seat);
            return true;
        }
    return false;
}

void NodeSeats::open(NodeSession& session) {
    Result<std::unique_ptr<Device>> device = open_();
    if (!device)
        return session.refuseScene(device.error().text());
    const std::uint64_t number = ++last_;
    // The renderer calls this on the render thread
    const auto answered = [this, number](LeaseAnswer one) {
        QMetaObject::invokeMethod(
            this, [this, number, one = std::move(one)]() mutable { answer(number, std::move(one)); },
            Qt::QueuedConnection);
    };
    taken_.push_back({number,
                      &session,
                      {NodeContents(session.key(), [this, number] { return memoryFor(number); }),
                       std::make_unique<LeaseRenderer>(*std::move(device), turns_, answered)},
                      nullptr,
                      now_()});
    session.sit(taken_.back().seat);
}

/// Promised memory counts twice while it is being allocated, which may refuse a scene that would just fit, but never
/// takes one that does not.
MemoryLeft NodeSeats::memoryFor(std::uint64_t number) const {
    MemoryLeft left{freeMemory_(), taken_.size() > 1};
    for (const Taken& one : taken_)
        if (one.number != number)
            left.bytes -= std::min(left.bytes, one.seat.contents.promised());
    return left;
}

void NodeSeats::answer(std::uint64_t number, LeaseAnswer answered) {
    const auto seat = std::ranges::find(taken_, number, &Taken::number);
    if (seat == taken_.end())
        return;
    const auto* lost = std::get_if<LeaseLost>(&answered);
    const bool isDeviceLost = lost && lost->error.kind == ErrorKind::deviceLost;
    const Error error = isDeviceLost ? lost->error : Error();
    if (seat->session)
        seat->session->answer(std::move(answered));
    if (isDeviceLost)
        emit deviceLost(error);
}

void NodeSeats::leave(NodeSession& session, bool isLost) {
    if (leaveLine(session))
        return advance();
    Taken* seat = seatOf(session);
    if (!seat)
        return;
    seat->session = nullptr;
    if (!isLost || !line_.empty())
        return forget(seat->number);
    seat->forgotten = std::make_unique<QTimer>();
    seat->forgotten->setSingleShot(true);
    // Queued, since it deletes the timer
    connect(
        seat->forgotten.get(), &QTimer::timeout, this, [this, number = seat->number] { forget(number); },
        Qt::QueuedConnection);
    seat->forgotten->start(kMemory);
}

/// Erases that seat, unless its coordinator has come back.
void NodeSeats::forget(std::uint64_t number) {
    std::erase_if(taken_, [&](const Taken& one) { return one.number == number && !one.session; });
    advance();
}

void NodeSeats::advance() {
    for (Taken& one : taken_)
        if (one.session)
            one.session->tryAgain();
    freeIdle();
    while (!line_.empty() && taken_.size() < most_) {
        NodeSession* next = line_.front().session;
        line_.erase(line_.begin());
        open(*next);
    }
    for (std::size_t place = 0; place < line_.size(); ++place)
        line_[place].session->wait(std::uint32_t(place + 1));
    if (line_.empty())
        look_.stop();
    else if (!look_.isActive())
        look_.start(kLook);
}

void NodeSeats::clear() {
    line_.clear();
    taken_.clear();
}

}  // namespace pdr::node
