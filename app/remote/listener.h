#pragma once
/// Accepts connections and keeps unknown peers cheap: no TLS before the peer has sent something, few handshakes at a
/// time per address and in all, and a time limit.

#include <QHash>
#include <QTcpServer>
#include <memory>

#include "app/remote/channel.h"
#include "app/remote/guest.h"
#include "app/remote/tls.h"

namespace pdr::remote {

struct ListenerLimits {
    int perAddress = 4;                         ///< connections of one address that are not admitted yet
    int inAll = 64;                             ///< connections of all addresses that are not admitted yet
    int waiting = 256;                          ///< connections that wait for a place among those, or have sent nothing
    std::chrono::milliseconds handshake{5000};  ///< time from the connection to the end of the TLS handshake
    ChannelLimits channel;
};

class Listener : public QObject {
    Q_OBJECT

  public:
    /// `identity`: identityFor(address, ...).
    explicit Listener(const Identity& identity, const ListenerLimits& limits = {}, QObject* parent = nullptr);
    ~Listener() override;

    /// Starts to listen. Errors: the address is not this machine's, the port is taken.
    Result<void> listen(const Address& address);
    /// Address at which it listens, with the actual port.
    Address address() const;

  signals:
    /// A peer has connected and has proved that it has the other role (plain TCP: without proof). The channel is the
    /// listener's child until it gets another parent, and occupies a place until Channel::setAdmitted().
    void connected(pdr::remote::Channel* channel);
    /// A peer was turned away before connected(); for a log.
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
    QList<Guest*> waiting_;            ///< connections that wait for a place or have sent nothing, by arrival
    QHash<QObject*, QString> places_;  ///< guests in their handshake and channels that are not admitted, by address
};

}  // namespace pdr::remote
