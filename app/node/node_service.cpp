#include "app/node/node_service.h"

#include <chrono>
#include <random>
#include <utility>

#include "app/node/introduction.h"
#include "render/device/device_list.h"
#include "render/tiles/worker_pool.h"

namespace pdr::node {
namespace {

/// Limit on coordinators that wait in line, or have no scan.
constexpr std::size_t kMostWaiting = 64;

/// Returns the time that turns are charged: on a GPU, a lease takes hardly any of the processors'.
FairTurns::Clock clockOf(const wire::Hello& hello) {
    return hello.device == "cpu" ? processorSeconds : poolSeconds;
}

}  // namespace

NodeService::NodeService(const NodeOptions& options, const wire::Hello& hello, OpenDevice open,
                         std::function<std::uint64_t()> freeMemory, std::function<std::chrono::microseconds()> now,
                         QObject* parent)
    : QObject(parent),
      options_(options),
      hello_(hello),
      backoff_({.giveUp = options.giveUp}),
      seats_(options.coordinators, std::move(open), clockOf(hello), std::move(freeMemory), std::move(now)) {
    for (QTimer* timer : {&again_, &idle_, &patience_})
        timer->setSingleShot(true);
    connect(&again_, &QTimer::timeout, this, &NodeService::dial);
    connect(&idle_, &QTimer::timeout, this, [this] {
        emit said(tr("nothing to do: this node ends"));
        drain();
    });
    connect(&patience_, &QTimer::timeout, this, [this] { finish(ExitCode::done); });
    connect(&seats_, &NodeSeats::deviceLost, this, [this](const Error& error) {
        emit said(QString::fromStdString(error.text()));
        finish(ExitCode::temporary);
    });
}

NodeService::~NodeService() {
    qDeleteAll(sessions_);
}

Result<void> NodeService::start() {
    const remote::Address& address = options_.listen ? *options_.listen : *options_.coordinator;
    Result<remote::Identity> identity = remote::identityFor(address, options_.bundle, remote::Role::node);
    if (!identity)
        return identity.error();
    identity_ = *std::move(identity);
    if (options_.idle.count() > 0)
        idle_.start(options_.idle);
    if (!options_.listen) {
        dial();
        return {};
    }
    listener_ = std::make_unique<remote::Listener>(identity_);
    connect(listener_.get(), &remote::Listener::connected, this, &NodeService::begin);
    connect(listener_.get(), &remote::Listener::turnedAway, this,
            [this](const QString& peer, const QString& reason) { emit said(peer + ": " + reason); });
    if (const Result<void> listens = listener_->listen(address); !listens)
        return listens.error();
    emit said(tr("listening at %1").arg(listener_->address().text()));
    return {};
}

void NodeService::dial() {
    dial_ = new remote::Dial(*options_.coordinator, identity_, {}, this);
    connect(dial_, &remote::Dial::connected, this, &NodeService::begin);
    connect(dial_, &remote::Dial::failed, this, [this](const Error& error) {
        std::exchange(dial_, nullptr)->deleteLater();
        if (error.kind == ErrorKind::refused) {
            emit said(QString::fromStdString(error.text()));
            finish(ExitCode::turnedAway);
        } else {
            dialLater(error);
        }
    });
}

void NodeService::dialLater(const Error& error) {
    if (draining_)
        return finish(ExitCode::done);
    const auto wait = backoff_.failed(remote::steadyTime(), std::generate_canonical<double, 53>(random_));
    if (!wait) {
        emit said(tr("given up: %1").arg(QString::fromStdString(error.text())));
        return finish(ExitCode::unreachable);
    }
    emit said(tr("%1; trying again in %2 s")
                  .arg(QString::fromStdString(error.text()))
                  .arg(double(wait->count()) / 1000, 0, 'f', 1));
    again_.start(*wait);
}

void NodeService::begin(remote::Channel* channel) {
    if (sessions_.size() >= std::size_t(options_.coordinators) + kMostWaiting) {
        channel->send(wire::Bye{phrase("this node works for somebody else")});
        channel->close("busy");
        connect(channel, &remote::Channel::closed, channel, &QObject::deleteLater);
        return;
    }
    auto* session = new NodeSession(channel, hello_, seats_, this);
    sessions_.push_back(session);
    if (dial_)
        std::exchange(dial_, nullptr)->deleteLater();
    connect(session, &NodeSession::welcome, this, [this, peer = channel->peerName()] {
        backoff_.succeeded();
        emit said(tr("works for %1").arg(peer));
    });
    connect(session, &NodeSession::worked, this, [this] {
        if (options_.idle.count() > 0)
            idle_.start(options_.idle);
    });
    connect(session, &NodeSession::drained, session, [session] { session->leave({}); });
    connect(session, &NodeSession::over, this, [this, session](const Text& reason) { ended(session, reason); });
}

void NodeService::ended(NodeSession* session, const Text& reason) {
    std::erase(sessions_, session);
    session->deleteLater();
    if (draining_ && sessions_.empty())
        return finish(ExitCode::done);
    emit said(tr("the connection has ended: %1; it had the device for %2 s")
                  .arg(QString::fromStdString(reason))
                  .arg(session->seconds(), 0, 'f', 2));
    if (listener_ || draining_)
        return;
    if (const std::optional<wire::Refused>& refusal = session->refusal())
        return finish(refusal->why == wire::Refused::Why::version ? ExitCode::protocol : ExitCode::turnedAway);
    dialLater({reason, options_.coordinator->text().toStdString(), ""});
}

void NodeService::goOnInstead(const Error& why) {
    QMetaObject::invokeMethod(
        this,
        [this, why] {
            nameDevice(hello_, makeCpuDevice(options_.threads)->info(), why);
            seats_.setDevice([threads = options_.threads] { return openDevice("cpu", threads); });
            for (NodeSession* session : sessions_)
                session->leave(phrase("its GPU has failed, and its CPU goes on: %1", why.what));
        },
        Qt::QueuedConnection);
}

void NodeService::drain() {
    if (std::exchange(draining_, true))
        return;
    patience_.start(options_.drain);
    listener_.reset();
    again_.stop();
    if (sessions_.empty())
        return finish(ExitCode::done);
    for (NodeSession* session : std::vector(sessions_))
        session->drain();
}

void NodeService::finish(ExitCode code) {
    draining_ = true;
    for (NodeSession* session : sessions_) {
        session->disconnect(this);
        session->leave({});
    }
    seats_.clear();
    emit finished(code);
}

}  // namespace pdr::node
