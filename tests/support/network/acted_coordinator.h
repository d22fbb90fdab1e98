#pragma once
/// A coordinator that does what a test says, at a node of this machine.

#include "app/coordinator/scene_order.h"
#include "app/remote/dial.h"
#include "app/wire/content.h"
#include "app/wire/content_hash.h"
#include "tests/support/network/heard.h"

namespace pdr::test {

class ActedCoordinator {
  public:
    /// Dials the node at that port, and welcomes it with this key.
    explicit ActedCoordinator(quint16 port, std::byte key = std::byte{1})
        : key_{key}, dial_({"127.0.0.1", port}, {remote::Role::coordinator, std::nullopt}) {
        QObject::connect(&dial_, &remote::Dial::failed, &dial_, [this] { isOver_ = true; });
        QObject::connect(&dial_, &remote::Dial::connected, &dial_, [this](remote::Channel* channel) {
            channel_ = channel;
            QObject::connect(channel, &remote::Channel::received, &dial_,
                             [this](wire::Message& message) { take(message); });
            QObject::connect(channel, &remote::Channel::closed, &dial_, [this] { isOver_ = true; });
        });
    }

    bool hasNode() const { return channel_ && channel_->isAdmitted(); }
    bool isOver() const { return isOver_; }  ///< whether there is no connection, or none any longer
    /// Returns the bytes of messages that are queued and not sent yet.
    qint64 waits() const { return channel_->queuedBytes(); }
    void say(wire::Message message) { channel_->send(std::move(message)); }
    /// Orders `scene` under that number, whose contents have hashes with `key`, by default its own.
    nodes::OutgoingScene order(std::uint64_t number, const Scene& scene, std::optional<std::byte> key = {}) {
        const nodes::ContentKey keyOfHashes = key ? nodes::ContentKey{*key} : key_;
        const auto hashOf = [&](const std::shared_ptr<const void>&, std::span<const std::byte> bytes) {
            return wire::contentHash(keyOfHashes, bytes);
        };
        nodes::OutgoingScene going = *nodes::outgoingScene(number, scene, hashOf);
        say(going.order);
        return going;
    }
    void send(const nodes::Content& content) {
        for (std::uint32_t i = 0; i < wire::chunksOf(content.bytes.size()); ++i)
            say(wire::packChunk(content.hash, content.bytes, i));
    }
    /// Returns all messages of a kind that have arrived.
    template <class Kind>
    std::vector<Kind> heard() const {
        return heardIn<Kind>(received_);
    }

  private:
    void take(wire::Message& message) {
        if (std::holds_alternative<wire::Hello>(message)) {
            channel_->setAdmitted();
            channel_->send(wire::Welcome{.version = 2, .heartbeatMs = 60000, .key = key_});
        }
        received_.push_back(std::move(message));
    }

    nodes::ContentKey key_{};
    std::vector<wire::Message> received_;
    bool isOver_ = false;
    remote::Channel* channel_ = nullptr;
    remote::Dial dial_;
};

}  // namespace pdr::test
