#pragma once
/// Dials an address once. Deleting it gives up.

#include <QTcpSocket>
#include <QTimer>
#include <chrono>

#include "app/remote/channel.h"
#include "app/remote/tls.h"

namespace pdr::remote {

struct DialLimits {
    std::chrono::milliseconds connecting{10000};  ///< for finding the host, TCP and TLS together
    ChannelLimits channel;
};

class Dial : public QObject {
    Q_OBJECT

  public:
    /// Begins at once. `identity`: identityFor(address, ...).
    Dial(const Address& address, const Identity& identity, const DialLimits& limits = {}, QObject* parent = nullptr);

  signals:
    /// One of the two, once, never before the constructor has returned.
    /// The other side is the other role's. Whether it takes this one is known no sooner than its first message: TLS 1.3
    /// lets those that it refuses through to here, and closes their channel. The channel is the dial's child until it
    /// gets another parent.
    void connected(pdr::remote::Channel* channel);
    /// ErrorKind::refused: the other side is not who it should be, and will not be the next time; else try again.
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
