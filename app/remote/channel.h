#pragma once
/// Messages over one connection, both ways, in order; only chunks wait for what is more urgent: a message sent after
/// some chunks may arrive before them. What is not sent yet is bounded, a connection that fails or is too slow ends,
/// and so does one whose other side breaks the protocol. Lives in one thread. Nothing here is emitted while send() or
/// close() runs. Delete it by deleteLater() within its signals.

#include <QElapsedTimer>
#include <QTcpSocket>
#include <QTimer>
#include <deque>
#include <memory>
#include <span>

#include "app/remote/drip_watch.h"
#include "app/remote/role.h"
#include "app/remote/token_bucket.h"
#include "app/wire/message_codec.h"
#include "app/wire/messages.h"

namespace pdr::wire {
class FrameReader;
}

namespace pdr::remote {

/// What a channel bears.
struct ChannelLimits {
    std::chrono::milliseconds admission{5000};  ///< to be admitted in
    std::chrono::milliseconds farewell{2000};   ///< for the last messages to go out
    std::chrono::milliseconds unheard{5000};    ///< by the other side's system, which takes or confirms nothing
    DripLimits drip;                            ///< of messages that come in
    /// That come in, but for chunks, leases and answers to leases. Twice the scenes of a coordinator (nodes::NodeLink),
    /// of which each has one answer; at once twice what piles up in the 10 s that a heartbeat bears.
    RateLimit messages{.perSecond = 500, .burst = 5000};
};

class Channel : public QObject {
    Q_OBJECT

  public:
    /// Bytes that may wait to be sent, where chunks are among them: a chunk may be sent while there are fewer.
    static constexpr qint64 kRoom = 4 << 20;
    /// Bytes that may wait whatever they are: an other side that takes so little is given up.
    static constexpr qint64 kMostQueued = 64 << 20;

    /// Owns `socket`, which is connected, and encrypted where it is to be. `role`: this side's.
    Channel(QTcpSocket* socket, Role role, const ChannelLimits& limits = {}, QObject* parent = nullptr);
    ~Channel() override;

    /// Takes it and returns at once. False, and nothing is taken: the channel is closed or closing; or `message` is a
    /// chunk and there is no room.
    bool send(wire::Message message);
    /// For a chunk. Ask this before a lease, too: more than a few make the other side's work old.
    bool hasRoom() const { return queuedBytes() < kRoom; }
    /// What waits to be sent: here and in the socket, not in the system.
    qint64 queuedBytes() const;
    qint64 bytesSent() const { return bytesSent_; }          ///< frames, without what encrypts them
    qint64 bytesReceived() const { return bytesReceived_; }  ///< likewise; grows as parts of messages arrive

    /// The other side has introduced itself, and is welcome: from now on it may send all messages, not only Hello,
    /// Welcome, Refused and Bye. A channel that is not admitted in time closes itself.
    void setAdmitted();
    bool isAdmitted() const { return admitted_; }

    /// Sends what waits but for chunks, then ends the connection. Receives nothing more.
    void close(const QString& reason);
    bool isOpen() const { return state_ == State::open; }
    /// It was closed since more messages came than it bears.
    bool wasFlooded() const { return flooded_; }

    /// "192.0.2.7:50123"
    QString peerName() const { return peerName_; }
    QString peerHost() const { return peerHost_; }

  signals:
    /// Who takes it may move out of it.
    void received(pdr::wire::Message& message);
    /// After there was no room: there is again.
    void roomForMore();
    void admitted();
    /// The connection is over. Exactly once, and the last signal. `reason`: this side's, or why it failed; for a log.
    void closed(const QString& reason);

  private:
    enum class State { open, closing, over };

    void begin();
    void read();
    void take(std::span<const std::byte> bytes);
    bool isFlood(const std::optional<wire::Message>& newest);
    bool mayCome(const wire::Message& message) const;
    qint64 inSocket() const;
    void pump(qint64 most);
    bool beginNextFrame();
    std::span<const std::byte> nextPiece() const;
    void written();
    void watch();
    void lose(const QString& reason);
    void finish(const QString& reason);

    QTcpSocket* socket_;
    ChannelLimits limits_;
    std::unique_ptr<wire::FrameReader> reader_;
    std::deque<wire::Frame> urgent_, chunks_;
    wire::Frame frame_;           ///< on its way into the socket ...
    std::size_t handedOver_ = 0;  ///< ... so much of it
    qint64 waiting_ = 0;          ///< bytes of urgent_, chunks_ and the rest of frame_
    qint64 bytesSent_ = 0, bytesReceived_ = 0;
    qint64 counted_ = 0;  ///< messages that came, in bucket_
    bool admitted_ = false;
    bool flooded_ = false;
    bool wasFull_ = false;
    State state_ = State::open;
    QString reason_;
    QString peerName_, peerHost_;
    DripWatch drip_;
    TokenBucket bucket_;
    QElapsedTimer clock_;
    QTimer watchTimer_;
    QTimer patience_;  ///< for being admitted, then for the last messages to go out
};

}  // namespace pdr::remote
