#pragma once
/// A coordinator that dials a node, welcomes it like any other and then does what a test says.

#include <algorithm>

#include "app/coordinator/scene_order.h"
#include "app/remote/dial.h"
#include "app/wire/content.h"
#include "app/wire/content_hash.h"

namespace pdr::test {

class ActedCoordinator {
  public:
    /// Dials a node at that port of this machine.
    explicit ActedCoordinator(quint16 port) : dial_(remote::Address{"127.0.0.1", port}, kCoordinator) {
        QObject::connect(&dial_, &remote::Dial::failed, &dial_, [this] { isOver_ = true; });
        QObject::connect(&dial_, &remote::Dial::connected, &dial_, [this](remote::Channel* channel) { meet(channel); });
    }

    bool isHeard() const { return heard_; }  ///< whether the node has introduced itself, and was welcomed
    bool isOver() const { return isOver_; }
    bool say(wire::Message message) { return channel_->send(std::move(message)); }
    void leave() { channel_->close("it goes"); }
    qint64 waits() const { return channel_->queuedBytes(); }
    /// Orders a scene, and sends its contents when the node asks for them.
    void order(const nodes::OutgoingScene& scene) {
        scene_ = scene;
        say(scene.order);
    }
    /// Returns `scene` as it is sent to this node.
    static nodes::OutgoingScene outgoing(const Scene& scene) {
        return *nodes::outgoingScene(scene.revision, scene, [](const auto&, std::span<const std::byte> bytes) {
            return wire::contentHash(wire::Welcome{}.key, bytes);
        });
    }
    template <class Kind>
    bool hasHeard() const {
        return std::ranges::any_of(received_, [](const auto& one) { return std::holds_alternative<Kind>(one); });
    }

  private:
    static inline const remote::Identity kCoordinator{remote::Role::coordinator, std::nullopt};

    void meet(remote::Channel* channel) {
        channel_ = channel;
        QObject::connect(channel, &remote::Channel::received, &dial_,
                         [this](wire::Message& message) { take(message); });
        QObject::connect(channel, &remote::Channel::closed, &dial_, [this] { isOver_ = true; });
    }
    void take(wire::Message& message) {
        if (std::holds_alternative<wire::Hello>(message) && !heard_) {
            channel_->setAdmitted();
            say(wire::Welcome{});
            heard_ = true;
        }
        if (const auto* need = std::get_if<wire::Need>(&message))
            serve(*need);
        received_.push_back(std::move(message));
    }
    void serve(const wire::Need& need) {
        for (const nodes::Content& content : scene_.contents)
            if (content.hash == need.content)
                for (std::uint32_t i = need.from; i < wire::chunksOf(content.bytes.size()); ++i)
                    say(wire::packChunk(content.hash, content.bytes, i));
    }

    std::vector<wire::Message> received_;
    nodes::OutgoingScene scene_;
    bool heard_ = false, isOver_ = false;
    remote::Channel* channel_ = nullptr;
    remote::Dial dial_;
};

}  // namespace pdr::test
