#pragma once
/// A node that introduces itself like any other and then does what a test says.

#include "app/coordinator/reference_bits.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"
#include "render/tiles/reference_tiles.h"
#include "tests/support/network/heard.h"

namespace pdr::test {

class ActedNode {
  public:
    /// Waits for a coordinator at a free port of this machine.
    explicit ActedNode(const wire::Hello& hello = helloOfThisMachine()) : hello_(hello), listener_(kNode) {
        if (!listener_.listen({"127.0.0.1", 0}))
            qFatal("no port is free");
        QObject::connect(&listener_, &remote::Listener::connected, &listener_,
                         [this](remote::Channel* channel) { meet(channel); });
    }
    /// Dials a coordinator at that port of this machine.
    explicit ActedNode(quint16 port, const wire::Hello& hello = helloOfThisMachine())
        : hello_(hello), listener_(kNode) {
        dial_ = std::make_unique<remote::Dial>(remote::Address{"127.0.0.1", port}, kNode);
        QObject::connect(dial_.get(), &remote::Dial::failed, &listener_,
                         [](const Error& error) { qFatal("%s", error.text().c_str()); });
        QObject::connect(dial_.get(), &remote::Dial::connected, &listener_,
                         [this](remote::Channel* channel) { meet(channel); });
    }

    static wire::Hello helloOfThisMachine() {
        wire::Hello hello;
        hello.program = hello.name = "acted";
        hello.boot = {std::byte{1}};
        hello.bits = nodes::bitsOf(*referenceTiles(*makeCpuDevice(1)));
        return hello;
    }

    /// Port at which it waits.
    quint16 port() const { return listener_.address().port; }
    bool say(wire::Message message) { return channel_->send(std::move(message)); }
    void leave() { channel_->close("it goes"); }
    bool isWelcome() const { return channel_ && channel_->isAdmitted(); }
    bool isOver() const { return isOver_; }
    int connections() const { return connections_; }  ///< number of connections so far
    /// Returns the bytes of messages that are queued and not sent yet.
    qint64 waits() const { return channel_->queuedBytes(); }
    /// Returns all messages of a kind that have arrived.
    template <class Kind>
    std::vector<Kind> heard() const {
        return heardIn<Kind>(received_);
    }

  private:
    static inline const remote::Identity kNode{remote::Role::node, std::nullopt};

    void meet(remote::Channel* channel) {
        channel_ = channel;
        isOver_ = false;
        ++connections_;
        QObject::connect(channel, &remote::Channel::received, &listener_,
                         [this](wire::Message& message) { take(message); });
        QObject::connect(channel, &remote::Channel::closed, &listener_, [this] { isOver_ = true; });
        channel->send(hello_);
    }
    void take(wire::Message& message) {
        if (std::holds_alternative<wire::Welcome>(message))
            channel_->setAdmitted();
        if (const auto* ping = std::get_if<wire::Ping>(&message))
            channel_->send(wire::Pong{ping->number});
        received_.push_back(std::move(message));
    }

    wire::Hello hello_;
    std::vector<wire::Message> received_;
    bool isOver_ = false;
    int connections_ = 0;
    remote::Channel* channel_ = nullptr;
    remote::Listener listener_;
    std::unique_ptr<remote::Dial> dial_;
};

}  // namespace pdr::test
