#pragma once
/// Dials an address once. Deleting a Dial gives up.

#include <QTcpSocket>
#include <QTimer>
#include <chrono>

#include "app/remote/channel.h"
#include "app/remote/tls.h"

namespace pdr::remote {

struct DialLimits {
    std::chrono::milliseconds connecting{10000};  ///< time for host lookup, TCP and TLS together
    ChannelLimits channel;
};

class Dial : public QObject {
    Q_OBJECT

  public:
    /// Begins to dial at once. `identity`: identityFor(address, ...).
    Dial(const Address& address, const Identity& identity, const DialLimits& limits = {}, QObject* parent = nullptr);

  signals:
    // Exactly one of the two signals is emitted, once, and never before the constructor has returned.
    /// The peer has the other role. Whether it accepts this side is known only with its first message: with TLS 1.3, a
    /// peer that rejects this side lets the connection come up to here, then closes the channel. The channel is the
    /// Dial's child until it gets another parent.
    void connected(pdr::remote::Channel* channel);
    /// The attempt has failed. ErrorKind::refused: the peer is not the one expected, and another attempt would fail,
    /// too; otherwise try again.
    void failed(const pdr::Error& error);

  private:
    void begin();
    void beginTls();
    void arrived();
    void fail(const Text& what, ErrorKind kind);

    Address address_;
    Identity identity_;
    DialLimits limits_;
    QTcpSocket* socket_ = nullptr;
    QTimer patience_;
};

}  // namespace pdr::remote
