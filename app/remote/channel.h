#pragma once
/// A channel sends and receives messages over one connection, in order, except that chunks have low priority: a message
/// sent after some chunks may arrive before them. The send queue is bounded. A connection that fails, is too slow, or
/// whose peer violates the protocol is closed. A channel lives in one thread and emits nothing while send() or close()
/// runs. Within its signals, delete it by deleteLater().

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

struct ChannelLimits {
    std::chrono::milliseconds admission{5000};  ///< time until setAdmitted()
    std::chrono::milliseconds farewell{2000};   ///< time to send the last messages
    std::chrono::milliseconds unheard{5000};    ///< time without an acknowledgement by the peer's TCP
    DripLimits drip;                            ///< minimum speed of incoming messages
    /// Limit on incoming messages except chunks, leases and answers to leases: twice the rate of a coordinator's scenes
    /// (nodes::NodeConnection), each of which has one answer; the burst is twice what queues up in the 10 s of the
    /// heartbeat.
    RateLimit messages{.perSecond = 500, .burst = 5000};
};

class Channel : public QObject {
    Q_OBJECT

  public:
    /// A chunk may be sent while fewer bytes than this are queued.
    static constexpr qint64 kRoom = 4 << 20;
    /// Limit on queued bytes; beyond it the connection is closed.
    static constexpr qint64 kMostQueued = 64 << 20;

    /// Takes ownership of `socket`, which is connected, and encrypted unless plain TCP is allowed. `role`: role of this
    /// side.
    Channel(QTcpSocket* socket, Role role, const ChannelLimits& limits = {}, QObject* parent = nullptr);
    ~Channel() override;

    /// Queues a message. Returns false and does not queue it if the channel is closed or closing, or if it is a chunk
    /// and there is no room.
    bool send(wire::Message message);
    /// Whether a chunk may be sent. Check this before sending a lease, too: queued leases grow stale.
    bool hasRoom() const { return queuedBytes() < kRoom; }
    /// Bytes to be sent, here and in the socket, without the kernel's buffers.
    qint64 queuedBytes() const;
    qint64 bytesSent() const { return bytesSent_; }          ///< bytes of frames, before encryption
    qint64 bytesReceived() const { return bytesReceived_; }  ///< decrypted bytes; grows as parts of messages arrive

    /// Records that the handshake has succeeded: the peer may send all messages from now on, not only Hello, Welcome,
    /// Refused and Bye. A channel that is not admitted in time closes itself.
    void setAdmitted();
    bool isAdmitted() const { return admitted_; }

    /// Sends all queued messages except chunks, then closes the connection. Receives nothing more.
    void close(const Text& reason);
    bool isOpen() const { return state_ == State::open; }
    /// Whether the channel was closed because of ChannelLimits::messages.
    bool wasFlooded() const { return flooded_; }

    /// Address and port of the peer: "192.0.2.7:50123".
    QString peerName() const { return peerName_; }
    QString peerHost() const { return peerHost_; }
    /// Name of the peer's certificate, if it is one node's alone; else empty.
    QString peerCertificate() const { return peerCertificate_; }

  signals:
    /// A message has arrived; the receiver may move from it.
    void received(pdr::wire::Message& message);
    /// hasRoom() is true again.
    void roomForMore();
    void admitted();
    /// The connection is over: emitted exactly once, as the last signal. `reason`: from close(), or of the failure.
    void closed(const pdr::Text& reason);

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
    void lose(const Text& reason);
    void finish(const Text& reason);

    QTcpSocket* socket_;
    ChannelLimits limits_;
    std::unique_ptr<wire::FrameReader> reader_;
    std::deque<wire::Frame> urgent_, chunks_;
    wire::Frame frame_;           ///< frame that is being written to the socket
    std::size_t handedOver_ = 0;  ///< bytes of frame_ that have been written
    qint64 waiting_ = 0;          ///< bytes of urgent_, chunks_ and the rest of frame_
    qint64 bytesSent_ = 0, bytesReceived_ = 0;
    qint64 counted_ = 0;  ///< received messages that bucket_ has counted
    bool admitted_ = false;
    bool flooded_ = false;
    bool wasFull_ = false;
    State state_ = State::open;
    Text reason_;
    QString peerName_, peerHost_, peerCertificate_;
    DripWatch drip_;
    TokenBucket bucket_;
    QElapsedTimer clock_;
    QTimer watchTimer_;
    QTimer patience_;  ///< time limit of the admission, then of the farewell
};

}  // namespace pdr::remote
