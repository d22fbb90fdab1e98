#include "app/node/node_service.h"

#include <chrono>
#include <random>
#include <utility>

#include "app/node/introduction.h"
#include "app/remote/steady_time.h"

namespace pdr::node {
namespace {

/// Time for which contents are kept after a connection was lost, in case the coordinator comes back.
constexpr std::chrono::seconds kMemory(60);

}  // namespace

NodeService::NodeService(const NodeOptions& options, const wire::Hello& hello, std::unique_ptr<Device> device,
                         QObject* parent)
    : QObject(parent), options_(options), hello_(hello), backoff_({.giveUp = options.giveUp}) {
    for (QTimer* timer : {&again_, &memory_, &idle_, &patience_})
        timer->setSingleShot(true);
    connect(&again_, &QTimer::timeout, this, &NodeService::dial);
    connect(&memory_, &QTimer::timeout, this, &NodeService::forget);
    connect(&idle_, &QTimer::timeout, this, [this] {
        emit said(tr("nothing to do: this node ends"));
        drain();
    });
    connect(&patience_, &QTimer::timeout, this, [this] { finish(ExitCode::done); });
    // The renderer calls this on the render thread
    renderer_ = std::make_unique<LeaseRenderer>(std::move(device), [this](LeaseAnswer answered) {
        QMetaObject::invokeMethod(
            this, [this, answered = std::move(answered)]() mutable { answer(std::move(answered)); },
            Qt::QueuedConnection);
    });
}

NodeService::~NodeService() {
    delete session_;
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
    if (session_) {  // one at a time
        channel->send(wire::Bye{phrase("this node works for somebody else")});
        channel->close("busy");
        connect(channel, &remote::Channel::closed, channel, &QObject::deleteLater);
        return;
    }
    session_ = new NodeSession(channel, hello_, contents_, *renderer_, this);
    if (dial_)
        std::exchange(dial_, nullptr)->deleteLater();
    connect(session_, &NodeSession::welcome, this, [this, peer = channel->peerName()] {
        backoff_.succeeded();
        memory_.stop();
        emit said(tr("works for %1").arg(peer));
    });
    connect(session_, &NodeSession::worked, this, [this] {
        if (options_.idle.count() > 0)
            idle_.start(options_.idle);
    });
    connect(session_, &NodeSession::drained, this, [this] { session_->leave({}); });
    connect(session_, &NodeSession::over, this, &NodeService::ended);
}

void NodeService::ended(const Text& reason) {
    NodeSession* session = std::exchange(session_, nullptr);
    session->deleteLater();
    if (draining_)
        return finish(ExitCode::done);
    emit said(tr("the connection has ended: %1").arg(QString::fromStdString(reason)));
    if (const std::optional<wire::Refused>& refusal = session->refusal()) {
        if (!listener_)
            return finish(refusal->why == wire::Refused::Why::version ? ExitCode::protocol : ExitCode::turnedAway);
    }
    if (session->wasDismissed())
        forget();
    else
        memory_.start(kMemory);
    if (!listener_)
        dialLater({reason, options_.coordinator->text().toStdString(), ""});
}

void NodeService::answer(LeaseAnswer answered) {
    if (const auto* lost = std::get_if<LeaseLost>(&answered); lost && lost->error.kind == ErrorKind::deviceLost) {
        if (session_)
            session_->answer(*lost);
        emit said(QString::fromStdString(lost->error.text()));
        finish(ExitCode::temporary);
    } else if (session_) {
        session_->answer(std::move(answered));
    }
}

void NodeService::goOnInstead(const Error& why) {
    QMetaObject::invokeMethod(
        this,
        [this, now = renderer_->info(), why] {
            nameDevice(hello_, now, why);
            if (session_)
                session_->leave(phrase("its GPU has failed, and its CPU goes on: %1", why.what));
        },
        Qt::QueuedConnection);
}

void NodeService::drain() {
    if (std::exchange(draining_, true))
        return;
    patience_.start(options_.drain);
    listener_.reset();
    again_.stop();
    if (session_)
        session_->drain();
    else
        finish(ExitCode::done);
}

void NodeService::forget() {
    contents_.forget();
    renderer_->forget();
}

void NodeService::finish(ExitCode code) {
    draining_ = true;
    if (session_)
        session_->leave({});
    forget();
    emit finished(code);
}

}  // namespace pdr::node
