#pragma once
/// A running render node: dials a coordinator or waits for one, and renders its leases.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <random>

#include "app/node/exit_codes.h"
#include "app/node/node_contents.h"
#include "app/node/node_options.h"
#include "app/node/node_session.h"
#include "app/remote/backoff.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"

namespace pdr::node {

class NodeService : public QObject {
    Q_OBJECT

  public:
    /// `hello`: first message to each coordinator. `device`: renders the leases.
    NodeService(const NodeOptions& options, const wire::Hello& hello, std::unique_ptr<Device> device,
                QObject* parent = nullptr);
    ~NodeService() override;

    /// Starts to dial or to listen. Errors: certificates, or an address at which this machine cannot listen.
    Result<void> start();
    /// Finishes open leases within the drain time, sends a Bye and ends.
    void drain();
    /// Leaves the coordinator, which counts on the speed of the GPU, and joins again as the device that has taken over.
    /// Called on the render thread, by the device. `why`: the GPU's error.
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
    void ended(const Text& reason);
    void finish(ExitCode code);
    void forget();
    void answer(LeaseAnswer answer);

    NodeOptions options_;
    wire::Hello hello_;
    NodeContents contents_;
    remote::Identity identity_;
    remote::Backoff backoff_;
    remote::Dial* dial_ = nullptr;
    std::unique_ptr<remote::Listener> listener_;
    NodeSession* session_ = nullptr;
    QTimer again_;     ///< dials again
    QTimer memory_;    ///< erases the contents after a connection was lost
    QTimer idle_;      ///< ends an idle node
    QTimer patience_;  ///< ends the draining
    bool draining_ = false;
    std::mt19937_64 random_{std::random_device()()};
    std::unique_ptr<LeaseRenderer> renderer_;  ///< last member, so that it is destroyed first: its thread calls back
};

}  // namespace pdr::node
