#pragma once
/// Accepts connections. Unknown peers are kept cheap: no TLS before the peer has sent something, few handshakes at a
/// time for one address and in all, and a time limit.

#include <QHash>
#include <QTcpServer>
#include <memory>

#include "app/remote/channel.h"
#include "app/remote/guest.h"
#include "app/remote/tls.h"

namespace pdr::remote {

struct ListenerLimits {
    int perAddress = 4;                         ///< connections of one address that are not admitted yet
    int inAll = 64;                             ///< likewise, of all addresses
    int waiting = 256;                          ///< connections that wait for a place among those, or have said nothing
    std::chrono::milliseconds handshake{5000};  ///< from the connection to the end of TLS' handshake
    ChannelLimits channel;
};

class Listener : public QObject {
    Q_OBJECT

  public:
    /// `identity`: identityFor(address, ...).
    explicit Listener(const Identity& identity, const ListenerLimits& limits = {}, QObject* parent = nullptr);
    ~Listener() override;

    /// Errors: the address is not this machine's, the port is taken.
    Result<void> listen(const Address& address);
    /// Where it listens; with the port that was free.
    Address address() const;

  signals:
    /// A connection whose other side has shown that it is the other role's (plain TCP: anybody). The channel is the
    /// listener's child until it gets another parent, and takes one of the places until Channel::setAdmitted().
    void connected(pdr::remote::Channel* channel);
    /// Somebody was sent away before; for a log.
    void turnedAway(const QString& peer, const QString& reason);

  private:
    void arrive(qintptr descriptor);
    void makeRoom();
    void seat();
    bool hasPlaceFor(const QString& host) const;
    void welcome(Guest* guest);
    void turnAway(Guest* guest, const QString& reason);
    void release(QObject* guestOrChannel);

    Identity identity_;
    ListenerLimits limits_;
    std::unique_ptr<QTcpServer> server_;
    QList<Guest*> waiting_;            ///< for a place, or to say something; by arrival
    QHash<QObject*, QString> places_;  ///< guests in their handshake and channels not admitted, with their addresses
};

}  // namespace pdr::remote
