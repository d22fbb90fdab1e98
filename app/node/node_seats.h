#pragma once
/// The seats of a node. A coordinator that has a scene takes one: contents, device and render thread of its own, which
/// nobody else uses and which go with it. All seats take turns at the processors or the GPU. Where all are taken,
/// coordinators wait in line, and one that has had no work for a minute loses its seat. Lives in the thread of the
/// sessions.

#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "app/node/node_contents.h"
#include "render/tiles/lease_renderer.h"

namespace pdr::node {

class NodeSession;

/// What a node has for one coordinator. Deleting it erases its scan.
struct NodeSeat {
    NodeContents contents;
    std::unique_ptr<LeaseRenderer> renderer;
};

/// Opens the device of a seat.
using OpenDevice = std::function<Result<std::unique_ptr<Device>>()>;

class NodeSeats : public QObject {
    Q_OBJECT

  public:
    /// `most`: number of seats. `clock`: see FairTurns. `freeMemory`: returns the bytes that may still be allocated.
    /// `now`: monotonic time.
    NodeSeats(int most, OpenDevice open, FairTurns::Clock clock, std::function<std::uint64_t()> freeMemory,
              std::function<std::chrono::microseconds()> now, QObject* parent = nullptr);
    ~NodeSeats() override;

    /// Sets what opens the devices of later seats.
    void setDevice(OpenDevice open) { open_ = std::move(open); }
    /// Gives `session` a seat by NodeSession::sit(): the one that its coordinator had before it lost its connection, or
    /// a new one. If there is none, it waits in line, and its NodeSession::wait() is called as the line moves.
    void ask(NodeSession& session);
    /// Records that the coordinator of `session` has work for it.
    void worked(const NodeSession& session);
    /// Takes the seat, or the place in the line, of `session` back, and gives it to the next one. `isLost`: the seat is
    /// kept for a minute, until somebody else needs one, since the connection was lost and its coordinator may return.
    void leave(NodeSession& session, bool isLost = false);
    /// Tries scenes again that there was not enough memory for, gives seats that are free, or whose coordinators have
    /// had no work for kIdle, to those who have waited longest, and tells the others their places. To be called when
    /// memory was freed, or a promise of it settled.
    void advance();
    /// Erases all seats.
    void clear();

    static constexpr std::chrono::seconds kIdle{60};

  signals:
    /// The device of a seat is lost, and nothing replaces it.
    void deviceLost(const pdr::Error& error);

  private:
    struct Taken {
        std::uint64_t number = 0;
        NodeSession* session = nullptr;  ///< null: its connection was lost
        NodeSeat seat;
        std::unique_ptr<QTimer> forgotten;   ///< erases a seat without a session
        std::chrono::microseconds worked{};  ///< time of its last work
    };
    struct Waiting {
        NodeSession* session = nullptr;
        bool isIdle = false;  ///< it has lost its seat, and has ordered no scene since: all others go first
    };

    Taken* seatOf(const NodeSession& session);
    bool leaveLine(const NodeSession& session);
    bool sitAgain(NodeSession& session);
    void open(NodeSession& session);
    MemoryLeft memoryFor(std::uint64_t number) const;
    void answer(std::uint64_t number, LeaseAnswer answered);
    void forget(std::uint64_t number);
    bool isIdle(const Taken& seat) const;
    void freeIdle();

    std::size_t most_;
    OpenDevice open_;
    FairTurns turns_;
    std::function<std::uint64_t()> freeMemory_;
    std::function<std::chrono::microseconds()> now_;
    QTimer look_;             ///< looks for idle seats while somebody waits
    std::uint64_t last_ = 0;  ///< number of the newest seat
    std::list<Taken> taken_;
    std::vector<Waiting> line_;  ///< those that are idle last
};

}  // namespace pdr::node
