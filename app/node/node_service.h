#pragma once
/// A render node at work: keeps a connection to a coordinator, or waits for one, and renders what it asks for.

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
    /// `hello`: all but what options say. `device` is for leases from now on.
    NodeService(const NodeOptions& options, const wire::Hello& hello, std::unique_ptr<Device> device,
                QObject* parent = nullptr);
    ~NodeService() override;

    /// Errors: certificates, or an address that cannot be listened at.
    Result<void> start();
    /// Finishes what it has, in the time that was allowed for it, says goodbye and ends.
    void drain();

  signals:
    void finished(pdr::node::ExitCode code);
    /// For the log: one line, nothing of any scene.
    void said(const QString& line);

  private:
    void dial();
    void dialLater(const Error& error);
    void begin(remote::Channel* channel);
    void ended(const QString& reason);
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
    QTimer again_;     ///< to dial
    QTimer memory_;    ///< until contents of a connection that was lost are forgotten
    QTimer idle_;      ///< without work
    QTimer patience_;  ///< for draining
    bool draining_ = false;
    std::mt19937_64 random_{std::random_device()()};
    std::unique_ptr<LeaseRenderer> renderer_;  ///< last, so that it ends first: its thread calls back
};

}  // namespace pdr::node
