#pragma once
/// A node that introduces itself as every other does, and then does what a test says.

#include "app/nodes/reference_bits.h"
#include "app/remote/dial.h"
#include "render/tiles/reference_tiles.h"

namespace pdr::test {

class ActedNode {
  public:
    /// Dials a coordinator at that port of this machine.
    explicit ActedNode(quint16 port, const wire::Hello& hello = helloOfThisMachine())
        : dial_({"127.0.0.1", port}, {remote::Role::node, std::nullopt}) {
        QObject::connect(&dial_, &remote::Dial::failed, &dial_,
                         [](const Error& error) { qFatal("%s", error.text().c_str()); });
        QObject::connect(&dial_, &remote::Dial::connected, &dial_, [this, hello](remote::Channel* channel) {
            channel_ = channel;
            QObject::connect(channel, &remote::Channel::received, &dial_,
                             [this](wire::Message& message) { take(message); });
            QObject::connect(channel, &remote::Channel::closed, &dial_, [this] { isOver_ = true; });
            channel->send(hello);
        });
    }

    static wire::Hello helloOfThisMachine() {
        wire::Hello hello;
        hello.program = hello.name = "acted";
        hello.boot = {std::byte{1}};
        hello.bits = nodes::bitsOf(*referenceTiles(*makeCpuDevice(1)));
        return hello;
    }

    bool say(wire::Message message) { return channel_->send(std::move(message)); }
    void leave() { channel_->close("it goes"); }
    bool isWelcome() const { return channel_ && channel_->isAdmitted(); }
    bool isOver() const { return isOver_; }
    /// What has been said and is not sent.
    qint64 waits() const { return channel_->queuedBytes(); }
    /// All of a kind that came.
    template <class Kind>
    std::vector<Kind> heard() const {
        std::vector<Kind> all;
        for (const wire::Message& message : received_)
            if (const auto* one = std::get_if<Kind>(&message))
                all.push_back(*one);
        return all;
    }

  private:
    void take(wire::Message& message) {
        if (std::holds_alternative<wire::Welcome>(message))
            channel_->setAdmitted();
        if (const auto* ping = std::get_if<wire::Ping>(&message))
            channel_->send(wire::Pong{ping->number});
        received_.push_back(std::move(message));
    }

    remote::Dial dial_;
    remote::Channel* channel_ = nullptr;
    std::vector<wire::Message> received_;
    bool isOver_ = false;
};

}  // namespace pdr::test
