#pragma once
/// A running render node: dials a coordinator or waits for several, and renders their leases.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <random>

#include "app/node/exit_codes.h"
#include "app/node/node_options.h"
#include "app/node/node_seats.h"
#include "app/node/node_session.h"
#include "app/remote/backoff.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"
#include "app/remote/steady_time.h"

namespace pdr::node {

class NodeService : public QObject {
    Q_OBJECT

  public:
    /// `hello`: first message to each coordinator. `open`: opens the devices that render, one for each coordinator.
    /// `freeMemory`: returns the bytes that scenes may still take. `now`: monotonic time.
    NodeService(const NodeOptions& options, const wire::Hello& hello, OpenDevice open,
                std::function<std::uint64_t()> freeMemory = freeBytes,
                std::function<std::chrono::microseconds()> now = remote::steadyTime, QObject* parent = nullptr);
    ~NodeService() override;

    /// Starts to dial or to listen. Errors: certificates, or an address at which this machine cannot listen.
    Result<void> start();
    /// Finishes open leases within the drain time, sends a Bye and ends.
    void drain();
    /// Leaves the coordinators, which count on the speed of the GPU, and joins again as the CPU, which has taken over.
    /// Called on a render thread, by the device. `why`: the GPU's error.
    void goOnInstead(const Error& why);

  signals:
    /// The node has ended; the program is to exit with `code`.
    void finished(pdr::node::ExitCode code);
    /// A line for the log; contains nothing about scenes.
    void said(const QString& line);

  private:
    void dial();
    void dialLater(const Error& error);
    void begin(remote::Channel* channel);
    void ended(NodeSession* session, const Text& reason);
    void finish(ExitCode code);

    NodeOptions options_;
    wire::Hello hello_;
    remote::Identity identity_;
    remote::Backoff backoff_;
    remote::Dial* dial_ = nullptr;
    std::unique_ptr<remote::Listener> listener_;
    NodeSeats seats_;
    std::vector<NodeSession*> sessions_;
    QTimer again_;     ///< dials again
    QTimer idle_;      ///< ends an idle node
    QTimer patience_;  ///< ends the draining
    bool draining_ = false;
    std::mt19937_64 random_{std::random_device()()};
};

}  // namespace pdr::node
